"""Texts for other packagers: each is read by the program that it is for, or as far as that goes without it."""

import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import types

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[3]


def test_citation(tmp_path):
    pytest.importorskip("cffconvert")
    convert = [sys.executable, "-c", "from cffconvert.cli.cli import cli; cli()", "-i", str(SOURCE / "CITATION.cff")]
    ran = subprocess.run([*convert, "--validate"], capture_output=True, text=True)
    assert ran.returncode == 0 and "valid" in ran.stdout, ran.stdout + ran.stderr
    ran = subprocess.run([*convert, "-f", "bibtex"], capture_output=True, text=True)
    assert "The roughcontact developers" in ran.stdout, ran.stdout + ran.stderr
    wrong = (SOURCE / "CITATION.cff").read_text().replace("title:", "titel:", 1)
    (tmp_path / "CITATION.cff").write_text(wrong)
    assert subprocess.run([*convert[:-1], str(tmp_path / "CITATION.cff"), "--validate"], capture_output=True).returncode


def test_bill_of_materials(tmp_path):
    validation = pytest.importorskip("cyclonedx.validation.json")
    from cyclonedx.schema import SchemaVersion

    (tmp_path / "roughcontact-9.8.7.tar.gz").write_bytes(b"archive")
    script = SOURCE / "scripts" / "bill_of_materials.py"
    ran = subprocess.run([sys.executable, script, "9.8.7", tmp_path], capture_output=True, text=True, env={**os.environ, "SOURCE_DATE_EPOCH": "0"})
    assert validation.JsonStrictValidator(SchemaVersion.V1_5).validate_str(ran.stdout) is None, ran.stdout + ran.stderr
    file = json.loads(ran.stdout)["components"][0]
    assert file["version"] == "9.8.7" and file["hashes"][0]["content"] == hashlib.sha256(b"archive").hexdigest()


RECIPE = SOURCE / "packaging" / "spack" / "package.py"


def test_spack_recipe(monkeypatch):
    """Run with stand-ins for Spack's directives: it declares what the build needs and turns variants into options."""
    directives = {name: [] for name in ("license", "version", "variant", "depends_on", "extends")}

    class CMakePackage:
        spec = types.SimpleNamespace(satisfies=lambda variant: variant in ("+cholmod", "+python"))

        def define(self, name, value):
            return f"-D{name}={';'.join(value) if isinstance(value, list) else value}"

        def define_from_variant(self, name, variant):
            assert variant in {arguments[0] for arguments in directives["variant"]}
            return self.define(name, True)

    spack = types.ModuleType("spack.package")
    for name, seen in directives.items():
        setattr(spack, name, lambda *arguments, _seen=seen, **_: _seen.append(arguments))
    spack.python_platlib = "/prefix/lib/python3.11/site-packages"
    cmake = types.ModuleType("cmake")
    cmake.CMakePackage = CMakePackage
    for name in ("spack", "spack_repo", "spack_repo.builtin", "spack_repo.builtin.build_systems"):
        monkeypatch.setitem(sys.modules, name, types.ModuleType(name))
    monkeypatch.setitem(sys.modules, "spack.package", spack)
    monkeypatch.setitem(sys.modules, "spack_repo.builtin.build_systems.cmake", cmake)
    names = {}
    exec(compile(RECIPE.read_text(), str(RECIPE), "exec"), names)
    assert {"eigen@3.4:", "gsl", "libzip", "pugixml", "cmake@3.22:"} <= {arguments[0] for arguments in directives["depends_on"]}
    arguments = names["Roughcontact"]().cmake_args()
    assert "-DRC_MODULE_BACKENDS=fft;split;cholmod" in arguments and any("RC_PYTHON_DIR=/prefix" in each for each in arguments)
    assert all(re.fullmatch(r"-D[A-Z0-9_]+=\S+", each) for each in arguments)


def test_style_of_the_spack_recipe():
    """What `spack style` looks at with flake8, under Spack's own settings."""
    pytest.importorskip("flake8")
    command = [sys.executable, "-m", "flake8", "--isolated", "--max-line-length=99", "--extend-ignore=F403,F405", str(RECIPE)]
    ran = subprocess.run(command, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr


@pytest.fixture(name="facts", scope="module")
def _facts(tmp_path_factory):
    """What a published release of the last commit would have, at an address on this machine."""
    folder = tmp_path_factory.mktemp("release")
    archive = folder / "roughcontact.tar.gz"
    subprocess.run(["git", "-C", SOURCE, "archive", "--prefix=roughcontact/", "-o", archive, "HEAD"], check=True)
    facts = dict(line.split("=", 1) for line in (SOURCE / "packaging" / "published.txt").read_text().splitlines() if "=" in line)
    whole = archive.read_bytes()
    facts |= {"archive": archive.as_uri(), "sha256": hashlib.sha256(whole).hexdigest(), "sha512": hashlib.sha512(whole).hexdigest()}
    (folder / "facts.txt").write_text("".join(f"{name}={value}\n" for name, value in facts.items()))
    return folder / "facts.txt"


@pytest.fixture(name="filled", scope="module")
def _filled(tmp_path_factory, facts):
    """The recipes with these facts."""
    out = tmp_path_factory.mktemp("recipes")
    subprocess.run([SOURCE / "packaging" / "recipes.sh", out, facts], check=True)
    return out


def test_recipes_are_filled_in(filled, facts):
    facts = dict(line.split("=", 1) for line in facts.read_text().splitlines())
    texts = {path.relative_to(filled): path.read_text() for path in filled.rglob("*") if path.is_file()}
    assert not [path for path, text in texts.items() if re.search(r"@[A-Z0-9]+@", text)]
    for kind, wanted in {"conan": "archive sha256 homepage", "vcpkg": "archive sha512 homepage", "spack": "archive sha256 homepage account",
                         "conda": "archive sha256 homepage account", "debian": "homepage maintainer"}.items():
        whole = "".join(text for path, text in texts.items() if path.parts[0] == kind)
        assert all(facts[name] in whole for name in wanted.split()), kind


@pytest.mark.parametrize("shared", [True, False])
def test_conan_recipe(filled, monkeypatch, tmp_path, shared):
    """Conan builds the package from the archive, with Eigen from the system, and runs its test program."""
    pytest.importorskip("conan")
    monkeypatch.setenv("CONAN_HOME", str(tmp_path))
    conan = [sys.executable, "-m", "conans.conan"]
    subprocess.run([*conan, "profile", "detect"], check=True, capture_output=True)
    with (tmp_path / "profiles" / "default").open("a") as profile:
        profile.write("\n[platform_requires]\neigen/3.4.0\n")
    create = [*conan, "create", filled / "conan", "-nr", "-o", f"roughcontact/*:shared={shared}"]
    ran = subprocess.run(create, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert ran.returncode == 0 and "load 0.445553" in ran.stdout, ran.stdout[-3000:]


def test_conda_recipe(filled):
    """rattler-build reads it and fills in versions; nothing is built, which would need a channel of packages."""
    rattler = pytest.importorskip("rattler_build")
    recipe = rattler.Stage0Recipe.from_file(str(filled / "conda" / "recipe.yaml"))
    variants = {"c_compiler": ["gcc"], "cxx_compiler": ["gxx"], "c_stdlib": ["sysroot"], "python": ["3.12"]}
    (rendered,) = recipe.render(rattler.VariantConfig(variants))
    found = rendered.recipe.to_dict()
    assert found["package"]["name"] == "roughcontact" and len(found["tests"]) == 2
    assert found["about"]["homepage"] and (SOURCE / found["about"]["license_file"][0]).exists()
    with pytest.raises(rattler.RattlerBuildError):
        rattler.Stage0Recipe.from_yaml("package: {name: a, version: '1'}\nbuidl: {number: 0}\n")


def test_vcpkg_manifest(filled):
    manifest = json.loads((filled / "vcpkg" / "vcpkg.json").read_text())
    assert manifest["name"] == "roughcontact" and re.fullmatch(r"\d+\.\d+\.\d+", manifest["version"])
    assert {"eigen3", "vcpkg-cmake"} <= {each if isinstance(each, str) else each["name"] for each in manifest["dependencies"]}
    assert (filled / "vcpkg" / "usage").exists()
