#!/usr/bin/env python3
"""A short batch of kills: nothing that was finished is lost, and every session goes on."""
import pathlib
import subprocess
import sys

harness = pathlib.Path(__file__).parent.parent / "reliability" / "crash_harness.py"
sys.exit(subprocess.run([sys.executable, str(harness), "--kills", "20", "--seed", "7"]).returncode)
