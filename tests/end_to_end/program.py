"""The program as a test calls it: in a folder of the test's own, without a display."""
import os
import pathlib
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def call(self, *arguments, **options):
        environment = {k: v for k, v in os.environ.items() if "DISPLAY" not in k}
        return subprocess.run([PROMENADE, *arguments], cwd=self.folder, text=True,
                              capture_output=True, timeout=120, env=environment, **options)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name
