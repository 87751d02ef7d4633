"""Writes a table, a list of dictionaries, to files."""
import csv
import json


def write_csv(filename, rows):
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with open(filename, "w", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)


def write_json(filename, value):
    with open(filename, "w") as file:
        json.dump(value, file, indent=1)
        file.write("\n")
