# SPDX-License-Identifier: GPL-3.0-or-later
"""What the programs that measure (planar/run.py and its like) have in common: running, medians, tables."""
import os
import statistics
import subprocess
import tempfile
import threading


def run(command, folder=None, accepted=(0,), seconds=None):
    """Runs a command; its output and its peak memory in units of 2^20 bytes. Output None if it had not ended after `seconds`."""
    with tempfile.TemporaryFile("w+", encoding="utf-8") as output:
        child = subprocess.Popen([str(c) for c in command], cwd=folder, stdout=output, stderr=subprocess.STDOUT)
        stopped = threading.Event()
        timer = threading.Timer(seconds, lambda: (stopped.set(), child.kill())) if seconds else None
        if timer:
            timer.start()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if timer:
            timer.cancel()
        output.seek(0)
        text = output.read()
    if stopped.is_set():
        return None, usage.ru_maxrss / 1024
    if child.returncode not in accepted:
        raise SystemExit(f"{command}: exit code {child.returncode}\n{text}")
    return text, usage.ru_maxrss / 1024


def figures(text):
    """The numbers of a line of pairs of a name and a number; other values are left out."""
    words = text.split()
    return {key: float(value) for key, value in zip(words[::2], words[1::2]) if value not in ("true", "false")}


def medians(calls, runs, at_most=None):
    """The median figures of each of several calls (a dictionary of names), taken in turn, so that a drift of the machine's speed hits
    all of them. `at_most` says which of them are to be run fewer times; those that are not run are left out."""
    results = {name: [] for name in calls}
    for i in range(runs):
        for name, call in calls.items():
            if i < (at_most or {}).get(name, runs):
                results[name].append(call())
    return {
        name: {key: statistics.median(r[key] for r in found) for key in found[0]} for name, found in results.items() if found
    }


def table(title, text, header, rows):
    """A section in Markdown: a heading, a paragraph if there is text, a table."""
    lines = [f"## {title}", ""] + ([text, ""] if text else [])
    lines += ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"
