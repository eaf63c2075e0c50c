"""A virtual display of a test's own."""
import os
import subprocess


class Display:
    """Killed by close(), or by hand when a test wants to lose it."""

    def __init__(self, width=1280, height=720):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with open(read) as number:  # the whole line: the server dies of a pipe that was closed early
            self.name = ":" + number.readline().strip()

    def close(self):
        self.server.kill()
        self.server.wait()
