#!/usr/bin/env python3
"""Turns what bench/measure left in a folder into a Markdown table: bench/studies/tables.py FOLDER TABLE, which is
engines, phases or stages."""

import json
import sys
from pathlib import Path

Row = list[str]


def results(folder: Path, pattern: str) -> list[dict]:
    """Complete results, in the order of their folders' names."""
    found = [json.loads(path.read_text()) for path in sorted(folder.glob(pattern))]
    return [result for result in found if not result["interrupted"]]


def print_table(heads: Row, rows: list[Row]) -> None:
    if not rows:
        sys.exit("tables.py: no result")
    for row in [heads, ["---"] * len(heads), *rows]:
        print("| " + " | ".join(row) + " |")


def duration(seconds: float) -> str:
    return f"{seconds:.3g} s" if seconds >= 1 else f"{seconds * 1e3:.3g} ms"


def engines(folder: Path) -> None:
    """Reference against parallel, by mesh and graph."""
    rows = []
    for result in results(folder, "compare-*/compare.json"):
        runs = result["runs"]
        regions = [r for r in runs if r["frontier"] == "regions" and r["backend"] == "tbb"]
        if not regions or runs[0]["engine"] != "reference":
            continue
        options, steps = result["options"], result["steps"]
        one, most = regions[0], regions[-1]
        reference, best = runs[0]["seconds"]["median"], most["seconds"]["median"]
        graph = options["graph"] + ("-anisotropic" if options["vfield"] else "")
        rows.append([
            f"{Path(result['mesh']['file']).stem}, {graph}, {options['seeds']} "
            f"{'given' if options['seeds_file'] else options['init']}",
            f"{steps['greedy']}, {steps['macro']}, {steps['micro']}",
            duration(reference),
            duration(one["seconds"]["median"]),
            f"{duration(best)} ({most['threads']})",
            f"{reference / best:.3g}",
            f"{most['peak_memory_bytes'] * 1e-6:.0f}",
            "equal" if all(r["equal"] for r in runs) else "DIFFERENT",
        ])
    print_table(["mesh, graph, seeds", "steps", "reference", "1 thread", "parallel (threads)", "ratio", "MB",
                 "results"], rows)


def share_in(profile: dict, phase: str) -> str:
    for part in profile["phases"]:
        if part["phase"] == phase:
            return f"{duration(part['seconds'])} {100 * part['search_share']:.0f} %"
    return ""


def phases(folder: Path) -> None:
    """Both engines by number of seeds, and the share of searches in each phase."""
    rows = []
    for result in sorted(results(folder, "profile-*/profile.json"), key=lambda r: r["options"]["seeds"]):
        reference, parallel = result["profiles"]
        rows.append([
            str(result["options"]["seeds"]), duration(reference["seconds"]), duration(parallel["seconds"]),
            f"{reference['seconds'] / parallel['seconds']:.3g}",
            *(share_in(profile, phase) for profile in (reference, parallel) for phase in ("greedy", "precise")),
        ])
    print_table(["seeds", "reference", "parallel", "ratio", "reference, greedy", "precise", "parallel, greedy", "precise"],
                rows)


def stage_of(name: str) -> tuple[str, str]:
    """What is timed, and by how many threads."""
    *parts, threads = name.removesuffix("/manual_time").split("/")
    mesh = next(i for i, part in enumerate(parts) if i > 0 and ("." in part or "creature-" in part))
    del parts[mesh]
    return "/".join(parts), threads.removeprefix("threads:")


def stages(folder: Path) -> None:
    """What Google Benchmark measured, by threads."""
    by_stage: dict[str, dict[str, float]] = {}
    for benchmark in json.loads((folder / "stages.json").read_text())["benchmarks"]:
        stage, threads = stage_of(benchmark["run_name"])
        by_stage.setdefault(stage, {})[threads] = benchmark["real_time"] / 1e3
    threads = sorted({t for by in by_stage.values() for t in by if t != "sequential"}, key=int)
    heads = ["stage", "sequential", *(f"{t} thread{'' if t == '1' else 's'}" for t in threads)]
    print_table(heads, [[stage, *(duration(by[t]) if t in by else "" for t in ("sequential", *threads))]
                        for stage, by in by_stage.items()])


TABLES = {table.__name__: table for table in (engines, phases, stages)}

if __name__ == "__main__":
    if len(sys.argv) != 3 or not Path(sys.argv[1]).is_dir() or sys.argv[2] not in TABLES:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    TABLES[sys.argv[2]](Path(sys.argv[1]))
