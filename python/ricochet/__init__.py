"""Contact laws for discrete-element simulation: calibrated, collided, fitted and stepped.

Names and SI units are those of the C++ library. Where a number is asked for, an array does as well: NumPy's rules of
broadcasting hold, and what went in as numbers alone comes back as numbers. Input outside its domain is a ValueError
that names the value and what is accepted.

    >>> import ricochet
    >>> law = ricochet.calibrate("linear", tcol=1e-4, en=0.5)
    >>> round(ricochet.collide(law, velocity=0.5, mass_eff=7.06858e-6).en, 9)
    0.5
"""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any, Dict, Generic, Mapping, Optional, Sequence, Tuple, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import *  # the laws, as classes Linear(k, c) …, and what needs no shaping
from ._core import Fit, ImpactBody, Interaction, Law, TangentialContact, Wall
from ._core import __version__ as __version__

Array = NDArray[np.float64]
Number = Union[float, Array]
Numbers = TypeVar("Numbers", float, Array)  # a number for numbers, an array for arrays


def _doubles(name: str, values: ArrayLike) -> Array:
    """As doubles: text, complex numbers, None and what a mask hides are none."""
    given = np.asanyarray(values)
    if isinstance(given, np.ma.MaskedArray) and np.any(given.mask):
        raise ValueError(f"{name}: has masked values, which must be filled or left out")
    reals = all(hasattr(type(one), "__float__") for one in given.flat) if given.dtype.kind == "O" else False
    if given.dtype.kind not in "biuf" and not reals:
        raise TypeError(f"{name}: must be real numbers, not {given.dtype}")
    return np.asarray(given, dtype=np.float64)


def _require_words(**words: Any) -> None:
    for name, word in words.items():
        if not isinstance(word, str):
            raise TypeError(f"{name} = {word!r}: must be a str")


def _number(name: str, value: Any) -> float:
    try:
        return float(_doubles(name, value))
    except (TypeError, ValueError):
        raise TypeError(f"{name} = {value!r}: must be a number") from None


def _count(name: str, value: Any, least: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} = {value!r}: must be a whole number") from None
    if number < least:
        raise ValueError(f"{name} = {number}: must be at least {least}")
    return number


@overload
def mittag_leffler(a: float, b: float, x: float) -> float: ...  # type: ignore
@overload
def mittag_leffler(a: ArrayLike, b: ArrayLike, x: ArrayLike) -> Array: ...
def mittag_leffler(a: ArrayLike, b: ArrayLike, x: ArrayLike) -> Number:
    """E_{a,b}(x) = sum x^k/Gamma(a k + b), elementwise, for 0 < a <= 3, 0 < b <= 120, -1e6 <= x <= 5.

    Relative error 1e-13 and 20 roundings of x.
    """
    flat, shape = _broadcast(a=a, b=b, x=x)
    return _shaped(_core._mittag_leffler(*flat, shape), shape)  # type: ignore[no-any-return]


@overload
def tcol_estimate(coefficient: float, alpha: float) -> float: ...  # type: ignore
@overload
def tcol_estimate(coefficient: ArrayLike, alpha: ArrayLike) -> Array: ...
def tcol_estimate(coefficient: ArrayLike, alpha: ArrayLike) -> Number:
    """Estimate (57) of the collision time [s], of A = c^alpha k^(1-alpha)/m [s^(alpha-2)]."""
    flat, shape = _broadcast(coefficient=coefficient, alpha=alpha)
    return _shaped(_core._tcol_estimate(*flat, shape), shape)  # type: ignore[no-any-return]


def _broadcast(**values: ArrayLike) -> Tuple[Sequence[NDArray[np.float64]], Tuple[int, ...]]:
    """The values as flat arrays of doubles of one length, and the shape that they had in common."""
    given = {name: _doubles(name, v) for name, v in values.items()}
    try:
        arrays = np.broadcast_arrays(*given.values())
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items() if array.shape)
        raise ValueError(f"shapes of {shapes}: must be such that one can be spread over the others") from None
    return [np.ascontiguousarray(a).ravel() for a in arrays], arrays[0].shape


def _spread(name: str, values: NDArray[Any], shape: Tuple[int, ...]) -> NDArray[Any]:
    try:
        return np.ascontiguousarray(np.broadcast_to(values, shape))
    except ValueError:
        raise ValueError(f"{name} of shape {values.shape}: must be {shape}, or one number for all") from None


def _shaped(flat: NDArray[Any], shape: Tuple[int, ...]) -> Any:
    return flat.reshape(shape) if shape else float(flat.reshape(-1)[0])


@dataclass(frozen=True, eq=False)
class FractionalContact(Generic[Numbers]):
    """A binary collision under the fractional law without units; see `fractional_contact`."""

    alpha: Numbers  #: conversion degree
    z_star: Numbers  #: A tcol^(2-alpha), A = c^alpha k^(1-alpha)/m
    tau: Numbers  #: tcol A^(1/(2-alpha))
    en: Numbers  #: restitution
    overlap_end: Numbers  #: [v0 tcol]
    z_max_overlap: Numbers  #: A t^(2-alpha) at the greatest overlap
    t_max_overlap: Numbers  #: [tcol]
    max_overlap: Numbers  #: [v0 tcol]
    t_max_force: Numbers  #: [tcol]
    max_force: Numbers  #: [m v0/tcol]


@overload
def fractional_contact(alpha: float, end: str = "force") -> FractionalContact[float]: ...  # type: ignore
@overload
def fractional_contact(alpha: ArrayLike, end: str = "force") -> FractionalContact[Array]: ...
def fractional_contact(alpha: ArrayLike, end: str = "force") -> Any:
    """The collision at conversion degree alpha, ended by "force" (-1 <= alpha < 1) or "overlap" (alpha < 0.40088…).

    Relative error 1e-12 by force, 1e-12 + 1e-15/en^2 by overlap.
    """
    _require_words(end=end)
    (flat,), shape = _broadcast(alpha=alpha)
    return FractionalContact(**{k: _shaped(v, shape) for k, v in _core._fractional_contact(flat, end, shape).items()})


@overload
def conversion_degree(en: float, end: str = "force") -> float: ...  # type: ignore
@overload
def conversion_degree(en: ArrayLike, end: str = "force") -> Array: ...
def conversion_degree(en: ArrayLike, end: str = "force") -> Any:
    """The conversion degree alpha that keeps `en`, in (0, 1], of the velocity."""
    _require_words(end=end)
    (flat,), shape = _broadcast(en=en)
    return _shaped(_core._conversion_degree(flat, end, shape), shape)


@dataclass(frozen=True, eq=False)
class Collision(Generic[Numbers]):
    """What a collision did; see `collide`."""

    status: Any  #: "ended_by_force", "ended_by_overlap", "permanent_contact", "no_separation", …
    tcol: Numbers  #: [s]
    en: Numbers  #: restitution
    max_overlap: Numbers  #: [m]
    time_max_overlap: Numbers  #: [s]
    max_force: Numbers  #: [N]
    time_max_force: Numbers  #: [s]
    overlap_end: Numbers  #: [m]


@dataclass(frozen=True, eq=False)
class ObliqueCollision:
    """What an oblique impact did; see `collide_obliquely`."""

    status: str
    tcol: float  #: [s]
    en: float
    et: Optional[float]  #: of the centres' tangential velocity; None where there was none
    beta: Optional[float]  #: of the contact point's slip, -1 … 1
    impulse_ratio: float  #: tangential over normal impulse
    velocity_i: NDArray[np.float64]  #: after [m/s]
    velocity_j: NDArray[np.float64]
    spin_i: NDArray[np.float64]  #: after [1/s]
    spin_j: NDArray[np.float64]
    impulse: NDArray[np.float64]  #: on i [N s]
    stick_time: float  #: [s]
    slip_time: float  #: [s]
    lost: Mapping[str, float]  #: by mechanism [J]


@overload
def collide(  # type: ignore
    law: Law, velocity: float, mass_eff: float, end: str = "force", method: str = "automatic"
) -> Collision[float]: ...
@overload
def collide(
    law: Law, velocity: ArrayLike, mass_eff: ArrayLike, end: str = "force", method: str = "automatic"
) -> Collision[Array]: ...
def collide(
    law: Law, velocity: ArrayLike, mass_eff: ArrayLike, end: str = "force", method: str = "automatic"
) -> Any:
    """The binary collision at these impact velocities [m/s] and effective masses [kg].

    Ended by "force" or "overlap"; method "automatic", "closed_form" or "numerical". Relative error of tcol and en
    1e-11 and better (<ricochet/collision/collision.hpp> has each law's). A collision that does not end is no error but
    a status, and its tcol, en and overlap_end are not a number; of a "permanent_contact" they are those at which it has
    come to rest, en 0. Of "out_of_range" nothing but the status is known, and the other numbers are 0.
    """
    _require_words(end=end, method=method)
    flat, shape = _broadcast(velocity=velocity, mass_eff=mass_eff)
    columns = _core._collide(law, *flat, end, method, shape)
    status = np.array(columns.pop("status"), dtype=object)
    return Collision(_shaped_words(status, shape), **{k: _shaped(v, shape) for k, v in columns.items()})


def _shaped_words(words: NDArray[Any], shape: Tuple[int, ...]) -> Any:
    return words.reshape(shape) if shape else words[0]


def collide_obliquely(
    law: Law,
    tangential: TangentialContact,
    i: ImpactBody,
    j: Optional[ImpactBody] = None,
    normal: ArrayLike = (0.0, 0.0, 1.0),
    end: str = "force",
    arm: str = "radius",
) -> ObliqueCollision:
    """One oblique impact of i on j (a wall, if nothing else is said), `normal` leading from i to j.

    `arm` is "radius" or "contact_point" (the paper's, nearer by half the overlap or so). Relative error 1e-9. Where the
    bodies do not part the status says so, and what they would have after it is not a number.
    """
    _require_words(end=end, arm=arm)
    other = ImpactBody.wall() if j is None else j
    for name, what, kind in (
        ("tangential", tangential, TangentialContact),
        ("i", i, ImpactBody),
        ("j", other, ImpactBody),
    ):
        if not isinstance(what, kind):
            raise TypeError(f"{name} = {what!r}: must be of {kind.__name__}")
    return ObliqueCollision(**_core._collide_obliquely(law, tangential, i, other, _doubles("normal", normal), end, arm))


_calibrator = _core._DirectCalibrator()


@overload
def calibrate(
    law: str,
    tcol: float,
    en: float,
    velocity: float = 0.5,
    mass_eff: float = 7.06858e-6,
    end: str = "force",
    stiffness: Optional[float] = None,
    alpha: Optional[float] = None,
    stiffening: Optional[float] = None,
    unreachable: str = "raise",
) -> Any: ...
@overload
def calibrate(
    law: str,
    tcol: ArrayLike,
    en: ArrayLike,
    velocity: ArrayLike = 0.5,
    mass_eff: ArrayLike = 7.06858e-6,
    end: str = "force",
    stiffness: Optional[ArrayLike] = None,
    alpha: Optional[float] = None,
    stiffening: Optional[float] = None,
    unreachable: str = "raise",
) -> Dict[str, Array]: ...
def calibrate(
    law: str,
    tcol: ArrayLike,
    en: ArrayLike,
    velocity: ArrayLike = 0.5,
    mass_eff: ArrayLike = 7.06858e-6,
    end: str = "force",
    stiffness: Optional[ArrayLike] = None,
    alpha: Optional[float] = None,
    stiffening: Optional[float] = None,
    unreachable: str = "raise",
) -> Any:
    """The parameters by which the law of that name collides for `tcol` [s] and keeps `en` of the velocity.

    At an impact of `velocity`, by default 0.5 m/s, and effective mass `mass_eff`, by default 7.06858e-6 kg: two spheres
    of 3 mm and 1000 kg/m^3. For numbers a law, for arrays a dict of arrays, one a parameter. What (tcol, en) leave open
    is held: `stiffness` [kg/s^2], the k of "fractional" and, where it is given, of "fractional-kelvin-voigt"; `alpha`
    of the laws of real solids ("fractional-kelvin-voigt", "fractional-hertz", "fractional-zener"), by default 0.5, and
    `stiffening`, k1/k of the last, by default 100; these two are numbers, for all targets. What a law does not hold is
    a ValueError.
    A target that the law can't reach is a ValueError that says which, why and what can be reached; with
    unreachable="nan" it is nan in arrays, None for numbers. Relative error 1e-11 in every parameter that (tcol, en)
    determine.
    """
    _require_words(law=law, end=end, unreachable=unreachable)
    if unreachable not in ("raise", "nan"):
        raise ValueError(f"unreachable = {unreachable}: must be raise or nan")
    held = np.nan if stiffness is None else stiffness
    flat, shape = _broadcast(tcol=tcol, en=en, velocity=velocity, mass_eff=mass_eff, stiffness=held)
    t, e, v, m, k = flat
    degree, ratio = (
        None if one is None else _number(name, one) for name, one in (("alpha", alpha), ("stiffening", stiffening))
    )
    columns = _calibrator(law, end, t, e, v, m, k, degree, ratio, unreachable == "nan", shape)
    if shape:
        return {name: column.reshape(shape) for name, column in columns.items()}
    if any(np.isnan(column[0]) for column in columns.values()):
        return None
    return _core.law(law, **{name: float(column[0]) for name, column in columns.items()})


def fit(
    law: str,
    velocity: ArrayLike,
    en: ArrayLike,
    en_sigma: Optional[ArrayLike] = None,
    tcol: Optional[ArrayLike] = None,
    tcol_sigma: Optional[ArrayLike] = None,
    mass_eff: float = 7.06858e-6,
    end: str = "force",
) -> Fit:
    """Fits the law of that name to measured rebounds by weighted least squares.

    Columns of one length: impact velocities [m/s], restitutions, and collision times [s] where they were measured; the
    standard errors are columns, too, or one number for all. `mass_eff` [kg].
    """
    _require_words(law=law, end=end)
    v, e = (np.ascontiguousarray(_doubles(name, column)) for name, column in (("velocity", velocity), ("en", en)))
    if v.ndim != 1 or e.shape != v.shape:
        raise ValueError(f"velocity of shape {v.shape}, en of shape {e.shape}: must be two columns of one length")
    t = np.empty(0) if tcol is None else np.ascontiguousarray(_doubles("tcol", tcol))
    if tcol is not None and t.shape != v.shape:
        raise ValueError(f"tcol of shape {t.shape}: must be a column as long as the others")
    if (tcol is None) != (tcol_sigma is None):
        raise ValueError("tcol, tcol_sigma: must be given together")
    sigmas = [
        np.empty(0) if s is None else _spread(name, _doubles(name, s), v.shape)
        for name, s in (("en_sigma", en_sigma), ("tcol_sigma", tcol_sigma))
    ]
    return _core._fit(law, end, _number("mass_eff", mass_eff), v, e, sigmas[0], t, sigmas[1])


def _rows(name: str, values: ArrayLike, count: int) -> NDArray[Any]:
    """A vector a sphere, or one for all."""
    given = _doubles(name, values)
    if given.shape not in ((3,), (count, 3)):
        raise ValueError(f"{name} of shape {given.shape}: must be (3,) or ({count}, 3)")
    return np.ascontiguousarray(np.broadcast_to(given, (count, 3)))


def _require_finite(positive: bool = False, **arrays: Array) -> None:
    for name, values in arrays.items():
        wrong = ~np.isfinite(values) | (values <= 0 if positive else False)
        if wrong.any():
            place = tuple(int(number) for number in np.argwhere(wrong)[0])
            accepted = "finite and > 0" if positive else "finite"
            raise ValueError(f"{name}[{', '.join(map(str, place))}] = {values[place]}: must be {accepted}")


def _whole(values: ArrayLike, count: int) -> Sequence[int]:
    given = np.asanyarray(values)
    if isinstance(given, np.ma.MaskedArray) or given.dtype.kind not in "iu" or (given < 0).any():
        raise ValueError(f"materials = {values!r}: must be whole numbers from 0")
    return [int(number) for number in _spread("materials", given, (count,))]


def _bodies(
    positions: ArrayLike,
    radii: ArrayLike,
    densities: ArrayLike,
    velocities: ArrayLike,
    spins: ArrayLike,
    materials: ArrayLike,
) -> Sequence[Any]:
    """One row, or number, a sphere."""
    x = np.ascontiguousarray(_doubles("positions", positions))
    if x.ndim != 2 or x.shape[1] != 3:
        raise ValueError(f"positions of shape {x.shape}: must be (n, 3)")
    n = x.shape[0]
    r, density = (
        _spread(name, _doubles(name, values), (n,))
        for name, values in (("radii", radii), ("densities", densities))
    )
    v, spin = _rows("velocities", velocities, n), _rows("spins", spins, n)
    _require_finite(positions=x, velocities=v, spins=spin)
    _require_finite(positive=True, radii=r, densities=density)
    return [x, r, density, v, spin, _whole(materials, n)]


Interactions = Union[Interaction, Mapping[Tuple[int, int], Interaction]]


def _pairs(interactions: Interactions) -> Sequence[Tuple[Tuple[int, int], Interaction]]:
    by_pair = {(0, 0): interactions} if isinstance(interactions, Interaction) else interactions
    if not isinstance(by_pair, Mapping):
        raise TypeError(f"interactions = {interactions!r}: must be an Interaction or a dict of them")
    for pair, how in by_pair.items():
        if not isinstance(how, Interaction):
            raise TypeError(f"interactions[{pair!r}] = {how!r}: must be an Interaction")
        if not (isinstance(pair, tuple) and len(pair) == 2):
            raise TypeError(f"interactions[{pair!r}]: must be a pair of materials, (0, 1) or so")
    return list(by_pair.items())


class Cluster:
    """Spheres and walls in motion; see <ricochet/motion/cluster.hpp> for the scheme and its order.

    Arrays with one row a sphere: positions [m], radii [m], densities [kg/m^3], velocities [m/s], spins [1/s],
    materials (numbers from 0); one number, or one vector, does for all. `interactions` is one Interaction for all, or a
    dict {(a, b): Interaction} by pair of materials. `gravity` [m/s^2]; `period` [m], in which space repeats itself
    along an axis, 0 where it does not (positions are not brought back). `step` [s], at most a 20th of the stiffest
    contact's time; None takes a fortieth. `solver_tolerance` is that of rigid friction's sweeps. Results do not depend
    on `threads`. While one thread of Python advances it, another one's look at it is a RuntimeError.
    """

    def __init__(
        self,
        positions: ArrayLike,
        radii: ArrayLike,
        densities: ArrayLike,
        interactions: Interactions,
        *,
        velocities: ArrayLike = (0.0, 0.0, 0.0),
        spins: ArrayLike = (0.0, 0.0, 0.0),
        materials: ArrayLike = 0,
        walls: Sequence[Wall] = (),
        gravity: ArrayLike = (0.0, 0.0, 0.0),
        period: ArrayLike = (0.0, 0.0, 0.0),
        step: Optional[float] = None,
        threads: int = 1,
        solver_tolerance: float = 1e-10,
    ) -> None:
        bodies = _bodies(positions, radii, densities, velocities, spins, materials)
        pairs = _pairs(interactions)
        for wall in walls:
            if not isinstance(wall, Wall):
                raise TypeError(f"walls: must be of Wall, not {wall!r}")
        around = [pairs, list(walls), _doubles("gravity", gravity)]
        time = _core._stiffest_contact(*bodies, *around)
        if step is None and time == 0:
            raise ValueError("step = None: must be given where no two bodies can touch")
        self._step = time / 40 if step is None else _number("step", step)
        if time > 0 and self._step > time / 20:
            raise ValueError(f"step = {step}: must be at most {time / 20:.6g} s, a 20th of the stiffest contact's time")
        self._never_pulls = all(how.end == "force" for _, how in pairs)
        self._engine = _core._Cluster(
            *bodies,
            *around,
            _doubles("period", period),
            self._step,
            _count("threads", threads, 1),
            _number("solver_tolerance", solver_tolerance),
        )

    def advance(self, steps: int) -> None:
        """Goes on by that many steps; RuntimeError where a number ceases to be finite."""
        self._engine.advance(_count("steps", steps, 0))

    def __len__(self) -> int:
        return len(self._engine)

    @property
    def step(self) -> float:
        """[s]"""
        return self._step

    @property
    def time(self) -> float:
        """[s]"""
        return self._engine.time

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 3) [m]"""
        return self._engine.positions

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 3) [m/s]"""
        return self._engine.velocities

    @property
    def spins(self) -> NDArray[np.float64]:
        """(n, 3) [1/s]"""
        return self._engine.spins

    @property
    def energy(self) -> Mapping[str, float]:
        """By kind [J]; "total" is constant up to the scheme's error."""
        return self._engine.energy

    @property
    def momentum(self) -> NDArray[np.float64]:
        """[kg m/s]"""
        return self._engine.momentum

    @property
    def angular_momentum(self) -> NDArray[np.float64]:
        """About the origin [kg m^2/s]"""
        return self._engine.angular_momentum

    @property
    def contacts(self) -> Mapping[str, NDArray[Any]]:
        """Those there are: "pairs" (walls count from the number of spheres), "overlap" [m], "force" [N] of repulsion.

        Where some contact ends by overlap the force is the law's own, negative where it would pull.
        """
        found = dict(self._engine.contacts)
        if self._never_pulls:
            found["force"] = np.maximum(found["force"], 0.0)
        return found

    def take_finished(self) -> Sequence[Mapping[str, Any]]:
        """Collisions that ended since the last call: i, j, begin, end, separation [s], how."""
        return self._engine.take_finished()


_made_here = (__name__, _core.__name__)
__all__ = ["Law", "law_names", "engine_names"] + [
    name
    for name, what in globals().items()
    if getattr(what, "__module__", None) in _made_here and not name.startswith("_")
]
