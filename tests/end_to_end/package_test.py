#!/usr/bin/env python3
"""The Debian package, made from the built tree: what is in it, what it asks for."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PROMENADE = pathlib.Path(os.environ["PROMENADE"])
SOURCE = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"])
CONFIGURATION = PROMENADE.parent / "package" / "CPackConfig.cmake"
VERSION = re.search(r"project\(promenade VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]


def run(*command, **options):
    return subprocess.run([*map(str, command)], text=True, capture_output=True, timeout=300,
                          **options)


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        # gzip, since nobody downloads this one.
        made = run("cpack", "--config", CONFIGURATION, "-B", cls.folder, "-D",
                   "CPACK_DEBIAN_COMPRESSION_TYPE=gzip")
        assert made.returncode == 0, made.stdout + made.stderr
        [cls.package] = cls.folder.glob("*.deb")
        cls.root = cls.folder / "root"
        run("dpkg-deb", "-x", cls.package, cls.root, check=True)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def field(self, name):
        return run("dpkg-deb", "-f", self.package, name).stdout.strip()

    def test_has_the_version_of_the_project(self):
        self.assertEqual(self.field("Version"), VERSION + "-1")
        self.assertRegex(self.package.name, r"^promenade_[0-9.]+-1_[a-z0-9]+\.deb$")
        self.assertEqual(run(self.root / "usr/bin/promenade", "--version").stdout,
                         f"promenade {VERSION}\n")

    def test_depends_on_what_it_runs_and_on_nothing_that_builds(self):
        depends = re.findall(r"[^,|() ]+(?= *[,|(]|$)", self.field("Depends"))
        for name in ("libc6", "libsqlite3-0", "gnuplot-nox", "fonts-noto-core",
                     "fonts-ipafont-gothic", "libgl1-mesa-dri", "libxrandr2"):
            self.assertIn(name, depends)
        self.assertEqual([name for name in depends if re.search(r"-dev$|^g\+\+|^cmake", name)], [])
        self.assertIn("r-base-core", self.field("Suggests"))

    def test_everybody_may_read_it_and_only_root_may_write(self):
        for line in run("dpkg-deb", "-c", self.package).stdout.splitlines():
            mode, owner = line.split()[:2]
            self.assertEqual(owner, "root/root", line)
            program = "/usr/bin/" in line or "/usr/libexec/promenade/" in line
            folder = mode.startswith("d")
            self.assertEqual(mode[1:], "rwxr-xr-x" if folder or program else "rw-r--r--", line)

    def test_holds_every_study_that_comes_with_the_program(self):
        self.same_files(SOURCE / "configs", self.root / "usr/share/promenade/configs")
        self.same_files(SOURCE / "docs", self.root / "usr/share/doc/promenade/docs")

    def same_files(self, ours, packed):
        names = [file.relative_to(ours) for file in ours.rglob("*") if file.is_file()]
        self.assertGreater(len(names), 10)
        for name in names:
            self.assertEqual((packed / name).read_bytes(), (ours / name).read_bytes(), name)

    def test_links_between_its_documents_lead_somewhere(self):
        documents = self.root / "usr/share/doc/promenade"
        for page in (documents / "README.md", *documents.glob("docs/*.md")):
            for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text()):
                self.assertTrue((page.parent / link).exists(), f"{page.name}: {link}")

    def test_has_what_debian_wants(self):
        documents = self.root / "usr/share/doc/promenade"
        self.assertIn("License: Expat", (documents / "copyright").read_text())
        changes = run("zcat", documents / "changelog.Debian.gz").stdout
        self.assertTrue(changes.startswith(f"promenade ({VERSION}-1) bookworm; "), changes)
        self.assertEqual(run("zcat", documents / "changelog.gz").stdout,
                         (SOURCE / "CHANGELOG.md").read_text())
        manual = run("zcat", self.root / "usr/share/man/man1/promenade.1.gz").stdout
        self.assertIn(".TP\n.B simulate\nSimulated participants", manual)
        self.assertNotIn("not in this version", manual)

    def test_knows_nothing_of_the_folder_in_which_it_was_built(self):
        for file in filter(pathlib.Path.is_file, self.root.rglob("*")):
            self.assertNotIn(os.fsencode(SOURCE) + b"/", file.read_bytes(), file)

    def test_the_icon_is_a_picture(self):
        icon = self.root / "usr/share/icons/hicolor/scalable/apps/promenade.svg"
        drawn = subprocess.run(["rsvg-convert", "-w", "48", icon], capture_output=True, check=True)
        self.assertTrue(drawn.stdout.startswith(b"\x89PNG"))

    def test_the_menu_names_what_is_there(self):
        entry = self.root / "usr/share/applications/promenade.desktop"
        keys = dict(re.findall(r"^([A-Za-z]+)=(.*)$", entry.read_text(), re.M))
        self.assertEqual(keys["Exec"], "promenade")  # the desk
        self.assertTrue(os.access(self.root / "usr/bin/promenade", os.X_OK))
        if shutil.which("desktop-file-validate"):
            self.assertEqual(run("desktop-file-validate", entry).stdout, "")

    @unittest.skipIf(shutil.which("lintian") is None, "lintian is not installed")
    def test_lintian_finds_no_error(self):
        result = run("lintian", "--fail-on", "error", "--allow-root", self.package)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
