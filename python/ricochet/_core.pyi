"""Types of what the C++ library gives the package."""

from typing import Any, ClassVar, Mapping, Optional, Sequence, Tuple, Type, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
law_names: Tuple[str, ...]

class _Law:
    name: ClassVar[str]
    units: ClassVar[Mapping[str, str]]
    @property
    def parameters(self) -> Mapping[str, float]: ...

class Linear(_Law):
    def __init__(self, k: float, c: float) -> None: ...
    k: float
    c: float

class KuwabaraKono(_Law):
    def __init__(self, k: float, c: float) -> None: ...
    k: float
    c: float

class Tsuji(_Law):
    def __init__(self, k: float, c: float) -> None: ...
    k: float
    c: float

class Hysteretic(_Law):
    def __init__(self, k1: float, k2: float) -> None: ...
    k1: float
    k2: float

class Fractional(_Law):
    def __init__(self, k: float, c: float, alpha: float) -> None: ...
    k: float
    c: float
    alpha: float

class FractionalKelvinVoigt(_Law):
    def __init__(self, k: float, c: float, alpha: float) -> None: ...
    k: float
    c: float
    alpha: float

class FractionalHertz(_Law):
    def __init__(self, k: float, c: float, alpha: float) -> None: ...
    k: float
    c: float
    alpha: float

class FractionalZener(_Law):
    def __init__(self, k: float, k1: float, tau: float, alpha: float) -> None: ...
    k: float
    k1: float
    tau: float
    alpha: float

Law = Union[
    Linear,
    KuwabaraKono,
    Tsuji,
    Hysteretic,
    Fractional,
    FractionalKelvinVoigt,
    FractionalHertz,
    FractionalZener,
]

def law(name: str, **parameters: float) -> Law: ...

class MittagLeffler:
    def __init__(self, a: float, b: float) -> None: ...
    a: float
    b: float
    def __call__(self, x: ArrayLike) -> Any: ...

class MemoryKernel:
    alpha: float
    shortest: float
    longest: float
    spring: float
    dashpot: float
    error: float
    strengths: NDArray[np.float64]
    rates: NDArray[np.float64]
    def __call__(self, t: ArrayLike) -> Any: ...

def memory_kernel(alpha: float, shortest: float, longest: float, tolerance: float = ...) -> MemoryKernel: ...

class Spring:
    def __init__(self, stiffness: float = ..., damping: float = ...) -> None: ...
    stiffness: float
    damping: float

class Friction:
    def __init__(
        self, mu_static: float = ..., mu_dynamic: Optional[float] = ..., decay: float = ..., rolling_arm: float = ...
    ) -> None: ...
    mu_static: float
    mu_dynamic: float
    decay: float
    rolling_arm: float

class RigidTangential:
    def __init__(self) -> None: ...

class LinearTangential:
    def __init__(self, k_t: float, c_t: float = ...) -> None: ...
    k_t: float
    c_t: float

class MindlinTangential:
    def __init__(self, k_t: float, c_t: float = ...) -> None: ...
    @staticmethod
    def of(shear_modulus_eff: float, radius_eff: float) -> MindlinTangential: ...
    k_t: float
    c_t: float

class TangentialContact:
    def __init__(
        self,
        law: Union[RigidTangential, LinearTangential, MindlinTangential] = ...,
        friction: Friction = ...,
        *,
        torsion_limit: str = ...,
        torsion_spring: Spring = ...,
        torsion_arm: float = ...,
        mu_rolling: float = ...,
        rolling_spring: Spring = ...,
    ) -> None: ...

class ImpactBody:
    def __init__(
        self, mass: float, radius: float, velocity: ArrayLike = ..., spin: ArrayLike = ..., inertia_ratio: float = ...
    ) -> None: ...
    @staticmethod
    def wall(velocity: ArrayLike = ...) -> ImpactBody: ...

class Estimate:
    name: str
    value: float
    error: float
    unit: str

class Fit:
    name: str
    parameters: Mapping[str, Estimate]
    correlations: Sequence[Sequence[float]]
    chi2: float
    observations: int
    freedom: int
    errors_known: bool
    aic: float
    probability: float
    findings: Sequence[str]
    def predict_en(self, velocity: ArrayLike) -> Any: ...

engine_names: Tuple[str, ...]

class Snippet:
    engine: str
    fidelity: str
    remarks: Sequence[str]
    text: str

def export_law(
    engine: str,
    law: Law,
    *,
    tcol: Optional[float] = ...,
    en: Optional[float] = ...,
    velocity: float = ...,
    mass_eff: float = ...,
    end: str = ...,
    radius_eff: Optional[float] = ...,
    density: Optional[float] = ...,
    tangential: Union[LinearTangential, MindlinTangential, None] = ...,
    mu: float = ...,
) -> Snippet: ...
def tangential_law_for(
    form: str,
    normal: Law,
    *,
    beta0: float,
    tcol: float,
    en: float,
    velocity: float = ...,
    mass_eff: float = ...,
    end: str = ...,
) -> Union[LinearTangential, MindlinTangential]: ...

class NotConverged(RuntimeError): ...

class Wall:
    @staticmethod
    def plane(
        point: ArrayLike, inward: ArrayLike, material: int = ..., velocity: ArrayLike = ...
    ) -> Wall: ...
    @staticmethod
    def cylinder(
        point: ArrayLike, axis: ArrayLike, radius: float, material: int = ..., spin: float = ...
    ) -> Wall: ...

def box_walls(low: ArrayLike, high: ArrayLike, material: int = ...) -> Sequence[Wall]: ...

class Interaction:
    def __init__(self, law: Law, tangential: TangentialContact = ..., end: str = ...) -> None: ...
    end: str

# Flat arrays; the package shapes what goes in and comes out.
class DirectCalibrator:
    def __init__(self) -> None: ...
    def __call__(
        self,
        law: str,
        end: str,
        tcol: NDArray[np.float64],
        en: NDArray[np.float64],
        velocity: NDArray[np.float64],
        mass_eff: NDArray[np.float64],
        stiffness: NDArray[np.float64],
        alpha: Optional[float],
        stiffening: Optional[float],
        skip: bool,
    ) -> Mapping[str, NDArray[np.float64]]: ...

class Cluster:
    def __init__(self, *parts: Any) -> None: ...
    def __len__(self) -> int: ...
    def advance(self, steps: int) -> None: ...
    def take_finished(self) -> Sequence[Mapping[str, Any]]: ...
    time: float
    steps: int
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]
    spins: NDArray[np.float64]
    energy: Mapping[str, float]
    momentum: NDArray[np.float64]
    angular_momentum: NDArray[np.float64]
    contacts: Mapping[str, NDArray[Any]]

def collide(*parts: Any) -> Any: ...
def collide_obliquely(*parts: Any) -> Any: ...
def conversion_degree(*parts: Any) -> Any: ...
def fit(*parts: Any) -> Fit: ...
def fractional_contact(*parts: Any) -> Any: ...
def mittag_leffler(a: ArrayLike, b: ArrayLike, x: ArrayLike) -> Any: ...
def stiffest_contact(*parts: Any) -> float: ...
def tcol_estimate(coefficient: ArrayLike, alpha: ArrayLike) -> Any: ...
