"""What a Markdown page is made of: prose, code, tables, headings. For the checks of documents."""

import functools
import re


class Block:
    """A paragraph, an item of a list, a run of code lines, a row of a table or a heading."""

    def __init__(self, kind, line, text):
        self.kind = kind  # "prose", "code", "table" or "heading"
        self.line = line  # its first, from 1
        self.text = text

    def line_at(self, offset):
        return self.line + self.text.count("\n", 0, offset)

    def code(self):
        """(line, text) of each line of code, or of each span in back-ticks, which may go over two lines."""
        if self.kind == "code":
            return [(self.line + i, line.strip()) for i, line in enumerate(self.text.split("\n"))]
        spans = re.finditer(r"`([^`]+)`", self.text)
        return [(self.line_at(span.start()), " ".join(span[1].split())) for span in spans]

    def without_code(self):
        """The same length, so that offsets stay."""
        return re.sub(r"`[^`]+`", lambda span: re.sub(r"[^\n]", "\0", span[0]), self.text)


@functools.lru_cache(maxsize=None)
def blocks(page):
    """The Blocks of the file PAGE, in order."""
    found = []
    fenced = after_blank = False
    with open(page, encoding="utf-8") as file:
        lines = file.read().split("\n")

    def extend(kind, number, line):
        last = found[-1] if found else None
        if last and last.kind == kind and last.line_at(len(last.text)) == number - 1 and not after_blank:
            last.text += "\n" + line
        else:
            found.append(Block(kind, number, line))

    for number, line in enumerate(lines, 1):
        in_prose = bool(found) and found[-1].kind == "prose" and not after_blank
        if line.lstrip().startswith("```"):
            fenced = not fenced
            after_blank = True
            continue
        if fenced:
            extend("code", number, line)
        elif not line.strip():
            after_blank = True
            continue
        elif line.lstrip().startswith("|"):
            found.append(Block("table", number, line))
        elif re.match(r"#{1,6} ", line):
            found.append(Block("heading", number, line))
        elif item := re.match(r"\s*(?:[*+-]|\d+\.)\s+", line):
            if line.startswith("    ") and not in_prose:
                extend("code", number, line)
            else:
                found.append(Block("prose", number, line[item.end() :]))
        elif line.startswith("    ") and not in_prose:
            extend("code", number, line)
        else:
            extend("prose", number, line)
        after_blank = False
    return found
