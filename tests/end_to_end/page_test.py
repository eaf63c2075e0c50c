#!/usr/bin/env python3
"""The page of a report in a real browser: valid, nothing cut off, nothing complained about."""
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]
CONFIGS = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"], "configs")
PEOPLE = {"demo": 7, "tour": 4}
WIDTHS = (1280, 400)
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
TIDY = shutil.which("tidy")
# Sent by the page to the one that frames it.
MEASURE = """<script>onload = () => parent.postMessage(
  innerWidth + " " + document.documentElement.scrollWidth, "*")</script>"""


def frames(page):
    """A page that shows `page` at each width and notes how wide it came out."""
    frame = "".join(f'<iframe src="{page}" style="width:{width}px;height:900px;border:0">'
                    "</iframe>" for width in WIDTHS)
    return ("<!DOCTYPE html><meta charset=utf-8><ol id=widths></ol><script>onmessage = (event) => "
            "widths.append(Object.assign(document.createElement('li'), {textContent: event.data}))"
            f"</script>{frame}")


class Outline(html.parser.HTMLParser):
    """Headings, pictures, tables and links of a page, in their order."""

    def __init__(self, text):
        super().__init__()
        self.headings, self.alts, self.links, self.ids, self.landmarks = [], [], [], [], []
        self.tables = self.captions = 0
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if re.fullmatch("h[1-6]", tag):
            self.headings.append(int(tag[1]))
        if tag == "img":
            self.alts.append(attributes.get("alt", ""))
        if tag == "a":
            self.links.append(attributes["href"])
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag in ("main", "header", "nav"):
            self.landmarks.append(tag)
        self.tables += tag == "table"
        self.captions += tag == "caption"

    handle_startendtag = handle_starttag


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        for name, people in PEOPLE.items():
            cls.promenade("simulate", CONFIGS / f"{name}.toml", "--participants", people, "--seed",
                          3, "--db", f"{name}.db")
            cls.promenade("report", f"{name}.db", "--include-simulated", "--out", name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def promenade(cls, *arguments):
        subprocess.run([PROMENADE, *map(str, arguments)], cwd=cls.folder, check=True,
                       capture_output=True, timeout=600)

    def chromium(self, *arguments):
        if not CHROMIUM:
            self.skipTest("chromium is not installed: the page was not opened in a browser")
        flags = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
                 "--disable-component-update", "--disable-sync", "--no-first-run",
                 "--disable-dev-shm-usage", "--hide-scrollbars", "--enable-logging=stderr",
                 "--force-color-profile=srgb", f"--user-data-dir={self.folder}/profile")
        return subprocess.run([CHROMIUM, *flags, *arguments], capture_output=True, text=True,
                              timeout=120, cwd=self.folder)

    def pages(self):
        return [(name, self.folder / name / "report.html") for name in PEOPLE]

    def test_is_valid(self):
        if not TIDY:
            self.skipTest("tidy is not installed: the page was not validated")
        for _, page in self.pages():
            result = subprocess.run([TIDY, "-errors", "-quiet", "-utf8", page], text=True,
                                    capture_output=True, timeout=60)
            self.assertEqual(result.stderr, "")

    def test_fits_wide_and_narrow_screens_and_has_no_console_error(self):
        for name, page in self.pages():
            measured = page.with_name("measured.html")
            measured.write_text(page.read_text().replace("</body>", MEASURE + "</body>"))
            framing = page.with_name("framing.html")
            framing.write_text(frames("measured.html"))
            result = self.chromium("--window-size=1800,1000", "--virtual-time-budget=5000",
                                   "--dump-dom", framing.as_uri())
            found = re.findall(r"<li>(\d+) (\d+)</li>", result.stdout)
            self.assertEqual(sorted(int(width) for width, _ in found), sorted(WIDTHS), name)
            for width, needed in found:
                self.assertLessEqual(int(needed), int(width), name)
            self.assertNotIn("CONSOLE", result.stderr)

    def test_prints_on_a4(self):
        for name, page in self.pages():
            pdf = self.folder / f"{name}.pdf"
            self.chromium(f"--print-to-pdf={pdf}", "--no-pdf-header-footer", page.as_uri())
            boxes = re.findall(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)", pdf.read_bytes())
            self.assertTrue(boxes)
            for width, height in boxes:
                self.assertAlmostEqual(float(width), 595.3, delta=1)
                self.assertAlmostEqual(float(height), 841.9, delta=1)

    def test_is_read_in_a_sensible_order(self):
        for _, page in self.pages():
            outline = Outline(page.read_text())
            self.assertEqual(outline.headings[0], 1)
            self.assertEqual(outline.headings.count(1), 1)
            for before, after in zip(outline.headings, outline.headings[1:]):
                self.assertLessEqual(after, before + 1)
            self.assertTrue(outline.alts and all(outline.alts))
            self.assertEqual(outline.tables, outline.captions)
            self.assertEqual(outline.landmarks, ["header", "main", "nav", "nav"])
            self.assertEqual(len(set(outline.ids)), len(outline.ids))

    def test_links_lead_somewhere(self):
        for _, page in self.pages():
            outline = Outline(page.read_text())
            for link in outline.links:
                if link.startswith("#"):
                    self.assertIn(link[1:], outline.ids)
                elif link != "analysis.R":  # written by another part of the report
                    self.assertTrue((page.parent / link).is_file(), link)

    def test_figures_can_be_drawn_again_from_their_scripts(self):
        for name, page in self.pages():
            again = self.folder / f"{name}-again"
            shutil.copytree(page.parent / "figures", again)
            for script in sorted(again.glob("*.gp")):
                svg = script.with_suffix(".svg")
                before = svg.read_bytes()
                svg.unlink()
                script.with_suffix(".pdf").unlink()
                subprocess.run(["gnuplot", script.name], cwd=again, check=True,
                               capture_output=True, timeout=60)
                self.assertEqual(svg.read_bytes(), before, script.name)
                self.assertTrue(script.with_suffix(".pdf").is_file())


if __name__ == "__main__":
    unittest.main()
