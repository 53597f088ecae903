#!/usr/bin/env bash
# sentences.sh ROOT: no sentence of the Markdown pages has more than 25 words. Code, tables and headings do not count.
# It covers the folders below, pages directly in them; the output names them, and how many pages lie elsewhere.
set -euo pipefail
export PYTHONPATH PYTHONDONTWRITEBYTECODE=1
PYTHONPATH=$(realpath "$(dirname "$0")")
exec python3 - "${1:?usage: sentences.sh ROOT}" <<'END'
import fnmatch, os, re, sys

from markdown import blocks

root = sys.argv[1]
covered = [".", "docs", "docs/*", "findings", "firmware", "firmware/*", "host_tools", "host_tools/*", "tests", "tests/*"]
most_words = 25

problems = []
pages = elsewhere = 0


def sentences(block):
    """(line, words) of each sentence of a paragraph."""
    text = re.sub(r"\]\([^)\s]*\)", lambda link: re.sub(r"[^\n]", "\0", link[0]), block.without_code())
    text = re.sub(r"\b(e\.g|i\.e|vs|al|cf)\.", r"\1 ", text)
    at = 0
    for end in [*re.finditer(r"[.!?][)\"*_\]\0]*(?=\s+[^a-z\s]|\s*$)", text), None]:
        sentence = text[at : end.end() if end else len(text)]
        words = [word for word in sentence.replace("\0", "").split() if re.search(r"\w", word)]
        begin = at + len(sentence) - len(sentence.lstrip())
        yield block.line_at(begin), words
        at += len(sentence)


for folder, below, names in os.walk(root):
    below[:] = [name for name in below if not name.startswith((".", "build")) and name != "node_modules"]
    inside = os.path.relpath(folder, root)
    looked_at = any(fnmatch.fnmatch(inside, pattern) for pattern in covered)
    for name in sorted(names):
        if not name.endswith(".md"):
            continue
        pages += looked_at
        elsewhere += not looked_at
        page = os.path.join(folder, name)
        for block in blocks(page) if looked_at else []:
            for line, words in sentences(block) if block.kind == "prose" else []:
                if len(words) > most_words:
                    problems.append(
                        f"{os.path.relpath(page, root)}:{line}: {len(words)} words: {' '.join(words[:8])} ..."
                    )

print("\n".join(sorted(problems)), file=sys.stderr, end="\n" if problems else "")
print(
    f"{pages} pages in {' '.join(covered)}: {len(problems)} sentences of more than {most_words} words"
    f" ({elsewhere} pages elsewhere are not covered)"
)
sys.exit(bool(problems))
END
