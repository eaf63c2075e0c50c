"""The desk in a real window, for tests and for pictures: real mouse and keyboard, on a display of its own."""
import os
import pathlib
import re
import signal
import subprocess
import time

from virtual_display import Display

PROMENADE = os.environ["PROMENADE"]


class Desk:
    def __init__(self, folder, width=1280, height=720, language="en"):
        self.folder = pathlib.Path(folder)
        self.display = Display(width, height)
        self.environment = {**os.environ, "DISPLAY": self.display.name,
                            "PROMENADE_OPENER": str(self.opener())}
        self.trace = self.folder / "trace"
        self.program = subprocess.Popen(
            [PROMENADE, "--studies", self.folder / "studies", "--language", language, "--trace",
             self.trace], cwd=self.folder, env=self.environment)
        self.wait(lambda: self.trace.exists(), 30)
        window = self.tool("search", "--sync", "--name", "^Promenade$").split()[0]
        self.tool("windowsize", window, str(width), str(height))
        self.tool("windowmove", window, "0", "0")
        self.tool("windowfocus", window)
        self.settle()

    def opener(self):
        """Stands in for a browser: notes what was to be shown."""
        script = self.folder / "opener"
        script.write_text(f'#!/bin/sh\nprintf "%s\\n" "$1" >> "{self.folder}/opened"\n')
        script.chmod(0o755)
        return script

    def opened(self):
        file = self.folder / "opened"
        return file.read_text().splitlines() if file.exists() else []

    def tool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.environment, text=True, check=True,
                              capture_output=True, timeout=60).stdout

    def close(self):
        if self.program.poll() is None:
            self.program.send_signal(signal.SIGINT)
            self.program.wait(timeout=30)
        self.display.close()
        return self.program.returncode

    @staticmethod
    def wait(done, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            found = done()
            if found:
                return found
            time.sleep(0.05)
        raise AssertionError(f"nothing came in {seconds} seconds")

    def settle(self):
        """Until what was done last has been drawn: each frame writes the trace anew."""
        for _ in range(4):
            seen = self.trace.stat().st_ino
            self.wait(lambda: self.trace.stat().st_ino != seen, 60)

    def controls(self):
        """Of all that is in sight: (kind, target) to (x, y, width, height)."""
        lines = [line.split("\t") for line in self.trace.read_text().splitlines()]
        return {(kind, target): tuple(map(float, box)) for kind, target, *box in lines}

    def find(self, kind, target):
        """The first whose target matches the pattern as a whole."""
        for (a_kind, a_target), box in self.controls().items():
            if a_kind == kind and re.fullmatch(target, a_target):
                return box
        return None

    def click(self, kind, target, seconds=60):
        try:
            x, y, width, height = self.wait(lambda: self.find(kind, target), seconds)
        except AssertionError:
            raise AssertionError(f"no {kind} {target} in {seconds} seconds, but "
                                 f"{sorted(self.controls())}") from None
        self.tool("mousemove", str(int(x + width / 2)), str(int(y + height / 2)))
        self.settle()
        self.tool("click", "1")
        self.settle()

    def scroll_to(self, kind, target, over):
        """Turns the wheel over another control until this one is in sight."""
        x, y, width, height = self.wait(lambda: self.find(*over))
        self.tool("mousemove", str(int(x + width / 2)), str(int(y + height / 2)))

        def turned():
            self.tool("click", "5")
            self.settle()
            return self.find(kind, target)
        self.wait(turned)

    def press(self, target, seconds=60):
        self.click("press", target, seconds)

    def write(self, target, text):
        """In place of what stands in the field."""
        self.click("type", target)
        self.tool("key", "ctrl+a")
        self.settle()
        self.tool("type", "--delay", "20", text)
        self.settle()

    def key(self, *names):
        self.tool("key", *names)
        self.settle()

    def go(self, place):
        self.click("go", place)

    def photograph(self, file):
        subprocess.run(["import", "-window", "root", str(file)], env=self.environment, check=True)
