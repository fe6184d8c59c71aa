#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts tables of bench/results into a Markdown page, and pictures drawn from them, between marks.

    fill_tables.py PAGE.md RESULTS_FOLDER

A mark is  <!-- table NAME -->  or  <!-- table NAME: column; column as heading; ... -->  and ends at  <!-- end -->.
Rows can be chosen:  <!-- table NAME: ... | column=value; column=value -->.
A picture's is  <!-- picture PATH: what it shows -->  with a path from the page.
"""

import csv
import pathlib
import re
import sys

MARK = re.compile(r"<!-- table (?P<name>\w+)(?:: (?P<columns>[^|]*?))?(?: \| (?P<rows>.*?))? -->\n.*?<!-- end -->", re.S)

PICTURE = re.compile(r"<!-- picture (?P<path>\S+): (?P<shows>.*?) -->\n.*?<!-- end -->", re.S)


def parts(text):
    return [part.strip() for part in text.split(";") if part.strip()]


def table(folder, mark):
    path = folder / f"{mark['name']}.csv"
    if not path.exists():
        return "(not measured)"
    with open(path, newline="") as file:
        reader = csv.DictReader(file)
        rows, columns = list(reader), reader.fieldnames
    chosen = [part.partition(" as ")[::2] for part in parts(mark["columns"] or "")] or [(c, "") for c in columns]
    for condition in parts(mark["rows"] or ""):
        column, _, value = condition.partition("=")
        rows = [row for row in rows if re.fullmatch(value, row[column])]
    for column, _ in chosen:
        if column not in columns:
            sys.exit(f"{path}: no column {column!r}")
    lines = ["| " + " | ".join(heading or column for column, heading in chosen) + " |",
             "|---|" + "---:|" * (len(chosen) - 1)]
    lines += ["| " + " | ".join(row[column] or "" for column, _ in chosen) + " |" for row in rows]
    return "\n".join(lines)


def picture(page, mark):
    return f"![{mark['shows']}]({mark['path']})" if (page.parent / mark["path"]).exists() else "(not drawn)"


def filled(mark, between):
    return mark[0].split("\n", 1)[0] + "\n" + between + "\n<!-- end -->"


def main():
    page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    text = page.read_text()
    text = MARK.sub(lambda mark: filled(mark, table(folder, mark)), text)
    page.write_text(PICTURE.sub(lambda mark: filled(mark, picture(page, mark)), text))


if __name__ == "__main__":
    main()
