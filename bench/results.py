"""The results of benchmark programs, and how their numbers are written."""
import json
import pathlib

UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


class Missing(KeyError):
    """A figure whose benchmark was not run."""


class Results:
    """All benchmarks of a folder of Google Benchmark's JSON files, by name."""

    def __init__(self, folder):
        self.by_name = {}
        self.context = {}
        for path in sorted(pathlib.Path(folder).glob("*.json")):
            text = path.read_text()
            if not text.strip():
                continue  # No benchmark of this program matched the filter.
            data = json.loads(text)
            self.context = data["context"]
            for entry in data["benchmarks"]:
                if entry.get("error_occurred"):
                    raise SystemExit(f"{entry['name']}: {entry['error_message']}")
                self.by_name[entry["name"].split("/iterations:")[0]] = entry

    def entry(self, name):
        if name not in self.by_name:
            raise Missing(name)
        return self.by_name[name]

    def value(self, name, counter):
        entry = self.entry(name)
        if counter not in entry:
            raise Missing(f"{name} {counter}")
        return entry[counter]

    def time(self, name):
        """Seconds: as the benchmark measured them, or else processor time."""
        entry = self.entry(name)
        key = "real_time" if name in self.by_name and "manual_time" in entry["name"] else "cpu_time"
        return entry[key] * UNITS[entry["time_unit"]]


def digits(value):
    """A positive number with three significant digits, without an exponent."""
    if value == 0:
        return "0"
    text = f"{value:.3g}"
    if "e" in text:
        text = f"{float(text):.0f}"
    return text


def seconds(value):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= 0.9995 * size:
            return f"{digits(value / size)} {unit}"
    return f"{digits(value / 1e-9)} ns"


def count(value):
    return f"{value:,.0f}"


def binary_bytes(value):
    return f"{digits(value / 2 ** 20)} MiB" if value >= 2 ** 17 else f"{digits(value / 2 ** 10)} KiB"


def plain_bytes(value):
    return f"{digits(value)} B"


def times(value):
    return f"{digits(value)} ×"


def table(head, rows):
    """A Markdown table; the first column is text, the others are numbers."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])
