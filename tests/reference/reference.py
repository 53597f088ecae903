#!/usr/bin/env python3
"""A second implementation of the gyro board's firmware, written from its specification alone.

reference.py TABLE STREAM -o OUT       the bytes that a replay of a sensor stream sends
reference.py --vectors FUNCTIONS       compare with spec_functions.txt (spec_stream.txt beside it has its table)
reference.py --stream-vectors FILE     compare with spec_stream.txt

Exit code: 0; 1 where vectors differ; 2 where something given is not accepted.
"""

import argparse
import sys

from pipeline import Replay
from table import Refused, read_file
from vectors import BadVectors, check_functions, check_stream


def replay(table_path, stream_path, out_path):
    with open(table_path, "rb") as file:
        table = read_file(file.read())
    with open(stream_path, "rb") as file:
        stream = file.read()
    sent = list(Replay(table).feed(stream))
    with open(out_path, "wb") as file:
        file.writelines(sent)
    print(f"{len(sent)} samples")
    return True


def compare(check, path):
    report, equal = check(path)
    print("\n".join(report))
    return equal


class OneLineParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"reference.py: {message}\n")


def arguments():
    parser = OneLineParser(description="Replay a sensor stream as the specification says.")
    parser.add_argument("table", nargs="?", metavar="TABLE", help="a model table, or a slot that has it inside")
    parser.add_argument("stream", nargs="?", metavar="STREAM", help="a captured sensor stream")
    parser.add_argument("-o", "--out", metavar="OUT", help="file for the bytes that are sent")
    parser.add_argument("--vectors", metavar="FUNCTIONS", help="compare with spec_functions.txt")
    parser.add_argument("--stream-vectors", metavar="FILE", help="compare with spec_stream.txt")
    given = parser.parse_args()
    of_replay = [given.table, given.stream, given.out]
    checks = given.vectors or given.stream_vectors
    if any(of_replay) if checks else not all(of_replay):
        parser.error("give TABLE STREAM -o OUT, or vectors to compare with")
    return given


def main():
    given = arguments()
    try:
        equal = True
        if given.vectors:
            equal = compare(check_functions, given.vectors)
        if given.stream_vectors:
            equal = compare(check_stream, given.stream_vectors) and equal
        if given.table:
            replay(given.table, given.stream, given.out)
    except (OSError, Refused, BadVectors) as error:
        print(f"reference.py: {error}", file=sys.stderr)
        return 2
    return 0 if equal else 1


if __name__ == "__main__":
    sys.exit(main())
