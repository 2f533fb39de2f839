"""The examples and the notebook do what they say."""

import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import origami_sim as origami

FOLDER = Path(__file__).resolve().parents[1]
EXAMPLES = FOLDER / "examples"


def needs(*modules, feature=None):
    missing = [module for module in modules if importlib.util.find_spec(module) is None]
    if missing:
        pytest.skip(f"needs {', '.join(missing)}")
    if feature is not None and feature not in origami.features:
        pytest.skip(f"needs the feature {feature}")


def run(name, *arguments, folder):
    environment = {**os.environ, "MPLBACKEND": "agg"}
    command = [sys.executable, EXAMPLES / name, *arguments]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_plot_takes_ten_lines(patterns, tmp_path):
    needs("matplotlib")
    run("plot.py", patterns / "crane.fold", "90", "crane.png", folder=tmp_path)
    assert (tmp_path / "crane.png").read_bytes().startswith(b"\x89PNG")
    code = [line for line in (EXAMPLES / "plot.py").read_text().splitlines()[1:] if line]
    assert len(code) <= 10


def test_a_design_is_found(tmp_path):
    needs("scipy")
    assert "gamma" in run("optimise.py", folder=tmp_path)


def test_a_design_is_found_by_gradients(tmp_path):
    needs("scipy", feature="analysis")
    assert "radii from the saddle" in run("inverse_design.py", folder=tmp_path)


@pytest.mark.parametrize(
    ("name", "module", "output"), [("to_trimesh.py", "trimesh", "bird.ply"), ("to_meshio.py", "meshio", "bird.vtu")]
)
def test_meshes_are_written(tmp_path, name, module, output):
    needs(module)
    run(name, output, folder=tmp_path)
    assert (tmp_path / output).stat().st_size > 400


def test_a_cluster_is_swept(tmp_path):
    needs("distributed")
    assert "strain at most" in run("sweep_on_dask.py", folder=tmp_path)
    assert len((tmp_path / "rows.csv").read_text().splitlines()) == 1 + 63


def test_every_example_compiles():
    for path in EXAMPLES.glob("*.py"):
        compile(path.read_text(), path, "exec")


def test_the_notebook_runs(tmp_path):
    needs("nbclient", "nbformat", "ipykernel", "matplotlib", "pandas", feature="newton")
    import nbclient
    import nbformat

    notebook = nbformat.read(EXAMPLES / "tutorial.ipynb", as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells), "outputs are made, not kept"
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": tmp_path}}).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert sum("image/png" in output.get("data", {}) for output in shown) == 6


def test_what_the_readme_shows_runs(tmp_path, patterns, monkeypatch):
    needs("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "crane.fold").write_bytes((patterns / "crane.fold").read_bytes())
    shown = re.findall(r"```python\n(.*?)```", (FOLDER / "README.md").read_text(), re.S)
    assert shown
    for code in shown:
        exec(compile(code, "README.md", "exec"), {"__name__": "readme"})


def test_everything_is_documented():
    for name in origami.__all__:
        thing = getattr(origami, name)
        if not callable(thing):
            continue
        assert thing.__doc__, name
        if isinstance(thing, type) and thing.__module__ == "origami_sim._native":
            for member in vars(thing):
                if not member.startswith("_"):
                    assert getattr(thing, member).__doc__, f"{name}.{member}"


def test_types_are_told_of_everything_there_is():
    from origami_sim import _native

    stubs = (FOLDER / "python" / "origami_sim" / "_native.pyi").read_text()
    for name in dir(_native):
        thing = getattr(_native, name)
        if name.startswith("_") or not callable(thing):
            continue
        assert re.search(rf"^(class|def) {name}\b", stubs, re.M), name
        if isinstance(thing, type):
            body = re.search(rf"^class {name}:\n((?:    .*\n|\n)*)", stubs, re.M).group(1)
            for member in vars(thing):
                if not member.startswith("_"):
                    assert re.search(rf"^    (def )?{member}\b", body, re.M), f"{name}.{member}"
