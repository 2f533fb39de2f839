"""What the tests share."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

import origami_sim as origami

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def patterns():
    """The folder of the patterns that come with the library."""
    return ROOT / "examples" / "patterns"


@pytest.fixture(scope="session")
def bird(patterns):
    return origami.Pattern.read(patterns / "bird-base.fold")


@pytest.fixture(scope="session")
def folded(bird):
    return origami.relax(bird, 90)


@pytest.fixture(scope="session")
def cli():
    """Runs the command `origami`, where it has been built: ORIGAMI_CLI, or in the workspace's target folder."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    places = [os.environ.get("ORIGAMI_CLI"), target / "release" / "origami", target / "debug" / "origami"]
    program = next((str(place) for place in places if place and shutil.which(place)), None)
    if program is None:
        # Where all that CI runs is run, a test that is left out has failed.
        if os.environ.get("CI"):
            pytest.fail("the command `origami` is not built")
        pytest.skip("the command `origami` is not built: cargo build --release")

    def run(*arguments, check=True):
        return subprocess.run([program, *map(str, arguments)], check=check, capture_output=True, text=True)

    return run
