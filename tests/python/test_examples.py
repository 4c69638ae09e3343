"""The examples run as they stand, and the page about Python shows them."""

import importlib.util
import pathlib
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples" / "python"


def printed(script, *arguments, cwd=None):
    return subprocess.run(
        [sys.executable, EXAMPLES / script, *arguments], check=True, capture_output=True, text=True, cwd=cwd
    ).stdout


def test_the_tutorial_prints_what_its_page_says():
    page = (ROOT / "docs" / "python.md").read_text()
    assert f"```python\n{(EXAMPLES / 'tutorial.py').read_text()}```" in page
    assert f"```text\n{printed('tutorial.py')}```" in page


def test_each_sample_becomes_a_deck_of_its_own(tmp_path):
    paths = printed("callback.py", str(tmp_path)).split()
    assert len(paths) == 5
    texts = {pathlib.Path(path).read_text() for path in paths}
    assert len(texts) == 5 and all("pair_coeff" in text for text in texts)


def test_a_deck_holds_the_stiffness_of_its_sample():
    spec = importlib.util.spec_from_file_location("callback", EXAMPLES / "callback.py")
    callback = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(callback)
    tcol, en, beta0, mu = 5e-5, 0.6, 0.5, 0.35
    text = callback.deck(tcol, en, beta0, mu)
    # The tangential spring by its closed form (half a period in tcol).
    mass_t = 2 / 7 * callback.MASS_EFF
    k_t = mass_t * (np.pi**2 + np.log(beta0) ** 2) / tcol**2
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    numbers = [float(word) for line in lines for word in line.split() if number(word)]
    assert min(abs(n - k_t) for n in numbers) < 1e-9 * k_t
    assert mu in numbers


def number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True
