#!/usr/bin/env python3
"""A study is packed before the first participant, and changed while it runs."""
import json
import sqlite3
import unittest

from program import ProgramTest

STUDY = """
[study]
name = "walks"
version = "1"
languages = ["en", "ja"]
[[interface]]
name = "labels"
[[interface]]
name = "adjectives"
[[task]]
name = "match"
kind = "match"
limit_s = 20
targets = [{ example = "happy" }, { example = "old" }]
[[questionnaire]]
instrument = "sus"
when = "end"
"""
CHANGED = STUDY.replace('version = "1"', 'version = "2"').replace("limit_s = 20", "limit_s = 30")


class Versions(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("walks.toml", STUDY)

    def good(self, *arguments):
        done = self.call(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def packed(self, study="walks.toml", out="walks.study"):
        return json.loads(self.good("pack", study, "--out", out, "--json"))

    def simulate(self, study, people, db="walks.db"):
        return self.call("simulate", study, "--participants", str(people), "--seed", "1",
                         "--db", db)

    def rows(self, sql, db="walks.db"):
        connection = sqlite3.connect(f"file:{self.folder / db}?mode=ro", uri=True)
        rows = connection.execute(sql).fetchall()
        connection.close()
        return rows

    def test_packing_twice_gives_the_same_bytes(self):
        self.packed()
        self.packed(out="again.study")
        self.packed("walks.study", out="of-the-pack.study")
        first = (self.folder / "walks.study").read_bytes()
        for name in "again.study", "of-the-pack.study":
            self.assertEqual((self.folder / name).read_bytes(), first)

    def test_the_hash_is_one_in_file_pack_and_database(self):
        pack = self.packed()
        self.assertEqual(pack["parts"], ["builtin:instruments/sus.toml",
                                         "builtin:languages/en.toml",
                                         "builtin:languages/ja.toml", "builtin:ratings/A.csv"])
        (self.folder / "elsewhere").mkdir()
        (self.folder / "walks.study").rename(self.folder / "elsewhere/any.name")
        for study in "walks.toml", "elsewhere/any.name":
            check = json.loads(self.good("check", study, "--json"))
            check = check[0] if isinstance(check, list) else check
            check = check.get("studies", [check])[0]
            self.assertEqual(check["sha256"], pack["sha256"])
            plan = json.loads(self.good("plan", study, "--participants", "4", "--json"))
            self.assertEqual(plan["sha256"], pack["sha256"])
            self.assertEqual(self.simulate(study, 2).returncode, 0)
        self.assertEqual(self.rows("SELECT study_sha256 FROM study"), [(pack["sha256"],)])
        self.assertEqual([path for path, in self.rows("SELECT path FROM study_part ORDER BY path")],
                         pack["parts"])

    def test_a_broken_pack_is_refused_with_a_sentence(self):
        self.packed()
        whole = (self.folder / "walks.study").read_bytes()
        for broken in whole[:-1], whole[:50], whole + b"x", whole.replace(b"happy", b"hapqy", 1):
            (self.folder / "broken.study").write_bytes(broken)
            done = self.call("check", "broken.study")
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"^broken\.study: error: [^\n]+\n$")

    def test_packing_never_writes_over_the_study(self):
        self.assertEqual(self.call("pack", "walks.toml", "--out", "./walks.toml").returncode, 2)
        self.assertEqual((self.folder / "walks.toml").read_text(), STUDY)

    def amended(self):
        self.assertEqual(self.simulate("walks.toml", 2).returncode, 0)
        self.write("changed.toml", CHANGED)
        return json.loads(self.good("amend", "walks.db", "changed.toml", "--reason", "too short",
                                    "--json"))

    def test_an_amended_study_goes_on_in_the_same_database(self):
        amended = self.amended()
        self.assertEqual((amended["previous_version"], amended["version"]), ("1", "2"))
        self.assertTrue(amended["same_orders"])
        self.assertEqual(self.simulate("changed.toml", 2).returncode, 0)
        self.assertEqual(
            self.rows("SELECT version, sequence, limit_s FROM session JOIN study ON "
                      "study.uuid = session.study JOIN trial ON trial.session = session.uuid "
                      "WHERE position = 1 ORDER BY sequence"),
            [("1", 0, 20), ("1", 1, 20), ("2", 2, 30), ("2", 3, 30)])

    def test_the_file_before_is_refused_with_date_and_reason(self):
        self.amended()
        done = self.simulate("walks.toml", 1)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r'newer version, "2", since 20\d\d-.* \(too short\)')

    def test_what_is_no_change_leaves_the_database_as_it_is(self):
        self.amended()
        broken = self.write("broken.toml", CHANGED.replace("happy", "hapy"))
        other = self.write("other.toml", CHANGED.replace('"walks"', '"runs"'))
        for study, reason in (("changed.toml", "x"), ("walks.toml", "x"), (broken, "x"),
                              (other, "x"), ("walks.toml", " ")):
            done = self.call("amend", "walks.db", study, "--reason", reason)
            self.assertEqual(done.returncode, 2, study)
        self.assertEqual(self.rows("SELECT count(*) FROM amendment"), [(1,)])

    def test_the_report_has_a_table_of_versions(self):
        self.amended()
        self.assertEqual(self.simulate("changed.toml", 3).returncode, 0)
        self.good("report", "walks.db", "--out", "report", "--include-simulated")
        report = json.loads((self.folder / "report/report.json").read_text())
        self.assertEqual([(one["version"], one["reason"], one["sessions"], one["finished"],
                           one["trials"]) for one in report["versions"]],
                         [("1", None, 2, 2, 8), ("2", "too short", 3, 3, 12)])
        page = (self.folder / "report/report.html").read_text()
        self.assertIn("too short", page)
        self.assertIn("changed 1 time", page)


if __name__ == "__main__":
    unittest.main()
