"""The parts of an HTML page, and the tables also as CSV files."""
import csv
import math
from collections import namedtuple
from html import escape
from pathlib import Path

STYLE = """body{font:15px/1.5 sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:1em 0}td,th{padding:.25em .8em;border-bottom:1px solid #ddd;text-align:right}
th{background:#f3f3f3}td:first-child,th:first-child{text-align:left}tr.printed td{color:#666;font-style:italic}
figure{display:inline-block;margin:.4em;text-align:center;vertical-align:top}figcaption{font-size:13px;color:#444}"""

Claim = namedtuple("Claim", "place text verdict numbers")


def claim(place, text, conditions, numbers):
    """Holds if all conditions do, and in part if some do; cannot be tested without conditions."""
    verdict = "cannot be tested" if not conditions else "holds" if all(conditions) else \
        "holds in part" if any(conditions) else "does not hold"
    return Claim(place, text, verdict, numbers)


def page(title, parts):
    return (f"<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>{escape(title)}</title>"
            f"<style>{STYLE}</style></head><body>\n<h1>{escape(title)}</h1>\n" + "\n".join(parts) + "\n</body></html>\n")


def heading(text):
    return f"<h2>{escape(text)}</h2>"


def paragraph(text):
    return f"<p>{escape(text)}</p>"


def number(x):
    if isinstance(x, str) or x is None:
        return x or ""
    if isinstance(x, int):
        return str(x)
    if math.isinf(x):
        return "-"
    return f"{x:.4g}" if abs(x) >= 1000 or 0 < abs(x) < 0.01 else f"{x:.3f}".rstrip("0").rstrip(".")


def table(filename, columns, rows, printed=()):
    """`printed` are the indices of the rows that the paper prints."""
    with open(filename, "w", newline="") as file:
        csv.writer(file).writerows([columns, *rows])
    lines = ["<tr>" + "".join(f"<th>{escape(c)}</th>" for c in columns) + "</tr>"]
    for i, row in enumerate(rows):
        attribute = " class='printed'" if i in printed else ""
        lines.append(f"<tr{attribute}>" + "".join(f"<td>{escape(number(x))}</td>" for x in row) + "</tr>")
    return f"<table>{''.join(lines)}</table>\n<p><a href='{escape(Path(filename).name)}'>as CSV</a></p>"


def figures(items, width=270):
    """items: (file, caption), side by side."""
    return "<div>" + "".join(f"<figure><img src='{escape(name)}' width='{width}' alt='{escape(caption)}'>"
                             f"<figcaption>{escape(caption)}</figcaption></figure>" for name, caption in items) + "</div>"
