#!/usr/bin/env python3
"""Kills the program at random moments, over and over, and counts what is lost.

    tests/reliability/crash_harness.py --kills 1700 --windowed 300 --seed 1

`simulate` is killed within a cohort; `run --autopilot` in its real window on a virtual display.
Both tell by --trace what they put into the database and what they called durable, so that this
program, which outlives them, knows what there was to lose. Every group of kills ends with a run
that nobody kills: then all sessions are finished, in the planned order, and the audit agrees.
"""
import argparse
import contextlib
import json
import os
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

POLICIES = ["continue", "trial", "block"]
KILLS_A_GROUP = {"simulate": 20, "window": 12}
STUDY = """
[study]
name = "crash"
seed = {seed}
[safety]
resume = "{policy}"
[[interface]]
name = "labels"
[[interface]]
name = "weights"
[[task]]
name = "first"
kind = "guess"
targets = [{{ example = "proud" }}, {{ example = "sad" }}]
limit_s = {limit}
[[task]]
name = "copy"
kind = "match"
start = "first"
threshold = "auto"
limit_s = {limit}
[[rating]]
item = "liked"
question = "How did you like it?"
"""


class Trace:
    """What the program says it does, with the time at which it was said."""

    def __init__(self, fifo):
        self.events, self.trials = {}, []  # (session, seq): when; uuids
        self.first_line = threading.Event()
        self._fifo = fifo
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self):
        with open(self._fifo, encoding="ascii") as lines:
            for line in lines:
                words = line.split()
                if words[:1] == ["event"] and len(words) == 3:
                    self.events[words[1], int(words[2])] = time.monotonic()
                elif words[:1] == ["trial"] and len(words) == 2:
                    self.trials.append(words[1])
                self.first_line.set()

    def end(self):
        self._thread.join(timeout=10)


class Group:
    """A database that is worked on by a row of processes, all but the last of which are killed."""

    def __init__(self, arguments, kind, number, folder, rng):
        self.kind, self.rng, self.folder = kind, rng, folder
        self.program = arguments.promenade
        self.db = folder / "crash.db"
        self.study = folder / "crash.toml"
        self.policy = POLICIES[number % len(POLICIES)]
        limit = 4 if kind == "window" else 60
        self.study.write_text(STUDY.format(seed=number + 1, policy=self.policy, limit=limit))
        self.seed = number
        self.result = {"kills": 0, "trials_finished": 0, "trials_lost": 0, "events": 0,
                       "events_lost": 0, "oldest_lost_ms": 0.0, "sessions_resumed": 0,
                       "sessions_finished": 0, "broken_files": 0, "wrong_orders": 0,
                       "audit_differences": 0}

    def command(self, fifo):
        if self.kind == "simulate":
            return [self.program, "simulate", self.study, "--participants", "2000", "--seed",
                    str(self.seed), "--db", self.db, "--jobs", "1", "--trace", fifo]
        return [self.program, "run", self.study, "--autopilot", str(self.seed), "--windowed",
                "--db", self.db, "--trace", fifo]

    def kill_once(self):
        fifo = self.folder / "trace"
        fifo.unlink(missing_ok=True)
        os.mkfifo(fifo, 0o600)
        trace = Trace(fifo)
        process = subprocess.Popen(list(map(str, self.command(fifo))),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        # Now and then before anything is stored; else within the work.
        longest = 0.6 if self.kind == "simulate" else 30.0
        if self.rng.random() > 0.1:
            trace.first_line.wait(timeout=120)
        time.sleep(self.rng.uniform(0, longest))
        killed = time.monotonic()
        process.send_signal(signal.SIGKILL)
        process.wait()
        # A reader of a pipe that nobody ever opened for writing waits for one.
        os.close(os.open(fifo, os.O_RDWR | os.O_NONBLOCK))
        trace.end()
        self.result["kills"] += 1
        self.judge(trace, killed)

    def judge(self, trace, killed):
        if not self.db.exists():
            return
        try:
            with contextlib.closing(sqlite3.connect(self.db)) as database:
                self.count_losses(database, trace, killed)
        except sqlite3.DatabaseError as error:
            print(f"{self.db}: {error}", file=sys.stderr)
            self.result["broken_files"] += 1

    def count_losses(self, database, trace, killed):
        result = self.result
        if database.execute("PRAGMA quick_check").fetchone() != ("ok",):
            result["broken_files"] += 1
        if database.execute("SELECT 1 FROM sqlite_schema WHERE name = 'event'").fetchone() is None:
            return  # killed while the file was made
        stored = dict(database.execute("SELECT session, max(seq) FROM event GROUP BY session"))
        ended = {row[0] for row in
                 database.execute("SELECT uuid FROM trial WHERE outcome IS NOT NULL")}
        result["trials_finished"] += len(trace.trials)
        result["trials_lost"] += sum(uuid not in ended for uuid in trace.trials)
        result["events"] += len(trace.events)
        for (session, seq), said in trace.events.items():
            if seq > stored.get(session, 0):
                result["events_lost"] += 1
                result["oldest_lost_ms"] = max(result["oldest_lost_ms"], 1e3 * (killed - said))

    def finish(self):
        """A run to the end, and what has become of all sessions."""
        if not self.db.exists():
            return
        if self.kind == "simulate":
            last = [self.program, "simulate", self.study, "--participants", "1", "--seed", "1",
                    "--db", self.db]
        else:
            last = [self.program, "run", self.study, "--autopilot", "1", "--windowed", "--db",
                    self.db]
        done = subprocess.run(list(map(str, last)), capture_output=True, text=True, timeout=900)
        if done.returncode != 0:
            print(done.stderr, file=sys.stderr)
            self.result["broken_files"] += 1
        with contextlib.closing(sqlite3.connect(self.db)) as database:
            self.check_orders(database)
        self.audit()

    def planned(self, sequences):
        text = subprocess.run([self.program, "plan", self.study, "--participants",
                               str(max(sequences) + 1), "--json"], capture_output=True,
                              text=True, check=True).stdout
        return [[(trial["position"], trial["task"], trial["interface"], trial["target"])
                 for trial in one["trials"]] for one in json.loads(text)["sequences"]]

    def check_orders(self, database):
        sessions = database.execute(
            "SELECT uuid, sequence, outcome, resumed FROM session").fetchall()
        if not sessions:
            return
        planned = self.planned([row[1] for row in sessions])
        for uuid, sequence, outcome, resumed in sessions:
            self.result["sessions_resumed"] += resumed > 0
            if outcome != "finished":
                # Of the window: somebody else's session was offered first, it waits on.
                self.result["wrong_orders"] += self.kind == "simulate"
                continue
            self.result["sessions_finished"] += 1
            trials = database.execute(
                "SELECT position, task, interface, target FROM trial WHERE session = ? AND "
                "superseded = 0 AND outcome IS NOT NULL ORDER BY started_us, position", (uuid,))
            if trials.fetchall() != planned[sequence]:
                print(f"session {uuid}: not in its planned order", file=sys.stderr)
                self.result["wrong_orders"] += 1

    def audit(self):
        said = subprocess.run([self.program, "replay", self.db, "--audit", "--json"],
                              capture_output=True, text=True, timeout=900)
        audit = json.loads(said.stdout)
        self.result["audit_differences"] += len(audit["differences"])
        for difference in audit["differences"][:5]:
            print(difference, file=sys.stderr)


def add(total, part):
    for key, value in part.items():
        total[key] = max(total.get(key, 0), value) if key == "oldest_lost_ms" \
            else total.get(key, 0) + value


def run_groups(arguments, kind, kills, rng, total):
    number = 0
    while total.get("kills", 0) < kills:
        with tempfile.TemporaryDirectory(prefix="promenade_crash_") as name:
            group = Group(arguments, kind, number, pathlib.Path(name), rng)
            for _ in range(min(KILLS_A_GROUP[kind], kills - total.get("kills", 0))):
                group.kill_once()
            group.finish()
            add(total, group.result)
            failed = any(group.result[key] for key in
                         ("trials_lost", "broken_files", "wrong_orders", "audit_differences"))
            if failed and arguments.keep:
                shutil.copytree(name, pathlib.Path(arguments.keep) / f"{kind}-{number}",
                                ignore=shutil.ignore_patterns("trace"))
        number += 1
        print(f"{kind}: {total}", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=20, help="of simulate")
    parser.add_argument("--windowed", type=int, default=0, help="kills of the window")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--promenade", default=os.environ.get("PROMENADE",
                                                              "build/release/promenade"))
    parser.add_argument("--keep", help="a folder for what went wrong")
    arguments = parser.parse_args()
    arguments.promenade = str(pathlib.Path(arguments.promenade).resolve())
    rng = random.Random(arguments.seed)
    totals = {}
    for kind, kills in (("simulate", arguments.kills), ("window", arguments.windowed)):
        if kills:
            totals[kind] = {}
            run_groups(arguments, kind, kills, rng, totals[kind])
    print(json.dumps(totals, indent=2))
    wrong = sum(total[key] for total in totals.values() for key in
                ("trials_lost", "broken_files", "wrong_orders", "audit_differences"))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
