"""What docs/tutorial.md shows: files to write, commands with what they print, words of a page.

In a shown output a line `...` stands for any lines, and `…` inside a line for any text."""
import dataclasses
import difflib
import html
import re

ANY_LINES = "..."


@dataclasses.dataclass
class Block:
    kind: str        # toml, console or text
    first: int       # index of its first line in the document
    lines: list


@dataclasses.dataclass
class Command:
    words: str
    first: int       # index in the document of the first line that it is shown to print
    shown: list


def blocks(document):
    """The fenced blocks of a document, a list of lines."""
    found, opened = [], None
    for number, line in enumerate(document):
        if not line.startswith("```"):
            continue
        if opened is None:
            opened = Block(line[3:].strip(), number + 1, [])
        else:
            opened.lines = document[opened.first:number]
            found.append(opened)
            opened = None
    if opened is not None:
        raise ValueError(f"the block of line {opened.first} has no end")
    return found


def commands(block):
    """The commands of a console block: `$ COMMAND`, which a backslash carries on."""
    found, number = [], 0
    while number < len(block.lines):
        line = block.lines[number]
        number += 1
        if not line.startswith("$ "):
            if not found:
                raise ValueError(f"line {block.first + number}: an output without a command")
            found[-1].shown.append(line)
            continue
        words = line[2:]
        while words.endswith("\\"):
            words = words[:-1].rstrip() + " " + block.lines[number].strip()
            number += 1
        found.append(Command(words, block.first + number, []))
    return found


def fits(shown, printed):
    pattern = ".*".join(re.escape(part) for part in shown.rstrip().split("…"))
    return re.fullmatch(pattern, printed.rstrip()) is not None


def first_wrong(shown, printed):
    """The index of the first line of `shown` that `printed` does not have, their number where
    more was printed, None where all is right."""
    reached = {0}
    for index, line in enumerate(shown):
        if line.strip() == ANY_LINES:
            reached = set(range(min(reached), len(printed) + 1))
        else:
            reached = {at + 1 for at in reached
                       if at < len(printed) and fits(line, printed[at])}
        if not reached:
            return index
    return None if len(printed) in reached else len(shown)


def shortened(shown, printed):
    """A printed line, with each cell between commas cut where the shown one is."""
    old, new = shown.split(","), printed.rstrip().split(",")
    if len(old) != len(new):
        return printed.rstrip()
    return ",".join(cell[:len(was) - 1] + "…" if was.endswith("…") and len(was) > 1 else cell
                    for was, cell in zip(old, new))


def nearest(line, printed, start):
    """Where, from `start` on, the line is printed, or one that is most like it; else None."""
    for at in range(start, len(printed)):
        if fits(line, printed[at]):
            return at
    likeness = [difflib.SequenceMatcher(None, line, shortened(line, other)).ratio()
                for other in printed[start:]]
    best = max(likeness, default=0)
    return start + likeness.index(best) if best > 0.6 else None


def renewed(shown, printed):
    """`shown` with what is printed now: lines that still fit stay, `...` stays where it was."""
    if first_wrong(shown, printed) is None:
        return shown
    if ANY_LINES not in (line.strip() for line in shown):
        return [next((old for old in shown if fits(old, line)), line.rstrip()) for line in printed]
    lines, at = [], 0
    for line in shown:
        if line.strip() == ANY_LINES:
            lines.append(line)
            continue
        found = nearest(line, printed, at)
        if found is not None:
            lines.append(line if fits(line, printed[found]) else shortened(line, printed[found]))
            at = found + 1
    return lines if first_wrong(lines, printed) is None else [line.rstrip() for line in printed]


def words_of_page(page):
    """The words of a page of HTML, a line for each element that stands by itself."""
    page = re.sub(r"<(style|svg|script)\b.*?</\1>", "", page, flags=re.DOTALL)
    page = re.sub(r"</(?!(a|b|em|i|span|strong|sub|sup)>)\w+>", "\n", page)
    lines = html.unescape(re.sub(r"<[^>]+>", "", page)).splitlines()
    return [" ".join(line.split()) for line in lines if line.strip()]
