"""The table of pymoo_compare.py: hypervolume at equal evaluations and at equal time, with tests and effect sizes."""
import csv, json
from pathlib import Path

ALGORITHMS = ["nsga2", "nsga3", "smsemoa"]
LINES = ["ours", "random", "hill"] + [f"{v}/{a}" for v in ("generic", "repair", "own") for a in ALGORITHMS]
SPARE = 1.15                   # a run goes on for so many times the time of our first one: our median may be above it


def curve(log, normal, moocore, np):
    """(evaluations, seconds, hypervolume of the archive) after each batch."""
    front, out = None, [(0, 0.0, 0.0)]
    for block in log:
        if block["f"]:
            F = np.array(block["f"], float)
            front = F if front is None else np.vstack([front, F])
            front = front[moocore.is_nondominated(front, keep_weakly=False)]
        out.append((block["evals"], block["t"], 0.0 if front is None else normal(front)))
    return np.array(out)


def last(values, x):
    """Index of the last entry up to x."""
    return int((values <= x + 1e-9).sum()) - 1


def at(c, column, x):
    return c[last(c[:, column], x), 2]


def holm(ps):
    """Holm's correction; `None` stays."""
    order, out, most = sorted((k for k in ps if ps[k] is not None), key=lambda k: ps[k]), dict.fromkeys(ps), 0.0
    for i, k in enumerate(order):
        most = max(most, min(1.0, ps[k] * (len(order) - i)))
        out[k] = most
    return out


def compared(ours, other, mannwhitneyu, np):
    """Two-sided Mann-Whitney p and A12, the chance that ours is higher."""
    if len(ours) < 2 or len(other) < 2:
        return None, float("nan")
    if np.array_equal(np.sort(ours), np.sort(other)):
        return 1.0, 0.5
    test = mannwhitneyu(ours, other)
    return float(test.pvalue), float(test.statistic) / len(ours) / len(other)


def table_of(brief, runs):
    """Rows of one brief from its runs {line: {seed: run}}; only seeds that every line has are compared."""
    import moocore, numpy as np
    from scipy.stats import mannwhitneyu
    seeds = sorted(set.intersection(*(set(r) for r in runs.values())))
    if not seeds:
        return [], []
    runs = {line: [found[s] for s in seeds] for line, found in runs.items()}
    every = np.vstack([np.array(b["f"], float) for found in runs.values() for r in found for b in r["log"] if b["f"]])
    union = every[moocore.is_nondominated(every, keep_weakly=False)]
    low, span = union.min(0), np.maximum(union.max(0) - union.min(0), 1e-12)
    reference = np.full(union.shape[1], 1.1)
    whole = moocore.hypervolume((union - low) / span, ref=reference)
    normal = lambda F: moocore.hypervolume((F - low) / span, ref=reference) / whole
    curves = {line: [curve(r["log"], normal, moocore, np) for r in found] for line, found in runs.items()}
    evals = runs["ours"][0]["planned"]
    seconds = min(float(np.median([r["cpu_s"] for r in runs["ours"]])), SPARE * runs["ours"][0]["cpu_s"])
    by_evals = {line: np.array([at(c, 0, evals) for c in cs]) for line, cs in curves.items()}
    by_time = {line: np.array([at(c, 1, seconds) for c in cs]) for line, cs in curves.items()}
    tests = {}
    for name, values in (("evals", by_evals), ("time", by_time)):
        raw = {line: compared(values["ours"], values[line], mannwhitneyu, np) for line in values if line != "ours"}
        corrected = holm({line: p for line, (p, _) in raw.items()})
        tests[name] = {line: (corrected[line], raw[line][1]) for line in raw}
    rows = []
    for line in [l for l in LINES if l in runs]:
        found = runs[line]
        share = sum(r["feasible_children"] for r in found) / max(1, sum(r["children"] for r in found))
        goal = float(np.median(by_evals[line]))
        reached = [next((int(e) for e, _, hv in c if hv >= goal), None) for c in curves["ours"]]
        known = [r for r in reached if r is not None]
        row = dict(brief=brief, line=line, seeds=len(seeds), evaluations=evals, hv_evals=goal,
                   hv_evals_q1=float(np.percentile(by_evals[line], 25)), hv_evals_q3=float(np.percentile(by_evals[line], 75)),
                   seconds=seconds, hv_seconds=float(np.median(by_time[line])), feasible_children=share,
                   evaluations_at_seconds=float(np.median([c[last(c[:, 1], seconds), 0] for c in curves[line]])))
        for name in tests:
            p, a12 = tests[name].get(line, (None, None))
            row |= {f"p_{name}": p, f"a12_{name}": a12}
        # The median over all seeds; a seed that never gets there counts as later than all others.
        ranked = sorted(known) + [float("inf")] * (len(reached) - len(known))
        row["ours_reaches_at"] = ranked[(len(ranked) - 1) // 2] if line != "ours" else None
        rows.append(row)
    return rows, seeds


def verdict(p, a12):
    if p is None:
        return "one seed"
    if p >= 0.01:
        return "no difference"
    return "ours better" if a12 > 0.5 else "OURS WORSE"


def write_table(args):
    rows, heads = [], []
    for folder in sorted(p for p in Path(args.out).iterdir() if p.is_dir()):
        runs, versions, days = {}, set(), set()
        for file in sorted(folder.glob("*.json")):
            r = json.loads(file.read_text())
            runs.setdefault(r["line"], {})[r["seed"]] = r
            versions.add(f"{r['program']} {r['version']}")
            days.add(r["date"])
        if "ours" not in runs:
            continue
        more, seeds = table_of(folder.name, runs)
        rows += more
        heads.append((folder.name, sorted(versions), sorted(days), seeds))
    target = Path(args.write)
    target.mkdir(parents=True, exist_ok=True)
    for row in rows:
        if row["ours_reaches_at"] == float("inf"):
            row["ours_reaches_at"] = "never"
    with open(target / "pymoo.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        short = lambda v: f"{v:.5g}" if isinstance(v, float) else v
        writer.writerows({k: short(v) for k, v in row.items()} for row in rows)
    (target / "pymoo.md").write_text(markdown(rows, heads, args.note))
    print(f"{target / 'pymoo.csv'}, {target / 'pymoo.md'}: {len(rows)} rows")


def markdown(rows, heads, note):
    number = lambda v, digits=4: "" if v is None or v != v else f"{v:.{digits}f}"
    small = lambda p: "" if p is None else (f"{p:.1e}" if p < 0.001 else f"{p:.3f}")
    out = ["# The search against pymoo", "",
           "Written by `tests/tools/pymoo_compare.py`, which says what the lines are and how to repeat this. Hypervolume of the archive of all",
           "feasible non-dominated houses, divided by that of the union of all runs of the brief (reference point: the union's worst values and a",
           "tenth of its range). p: Mann-Whitney, two-sided, ours against the line, Holm-corrected over the lines of the brief; A12: chance that a",
           "run of ours is better. A difference is named below p = 0.01. Time is processor time on one thread.", ""]
    if note:
        out += [note, ""]
    for brief, versions, days, seeds in heads:
        mine = [r for r in rows if r["brief"] == brief]
        if not mine:
            continue
        span = days[0] if days[0] == days[-1] else f"{days[0]} to {days[-1]}"
        out += [f"## {brief}", "",
                f"{span}; {', '.join(versions)}; {len(seeds)} seeds; {mine[0]['evaluations']} evaluations, or {mine[0]['seconds']:.1f} s of processor time "
                "(the median of ours).", "",
                "| line | hypervolume at equal evaluations | p | A12 | | hypervolume at equal seconds | evaluations by then | p | A12 | | feasible children | ours gets as far at |",
                "|---|---|---|---|---|---|---|---|---|---|---|---|"]
        for r in mine:
            ours = r["line"] == "ours"
            reached = "" if ours else (f"{r['ours_reaches_at']} ({100 * r['ours_reaches_at'] / r['evaluations']:.0f} %)"
                                       if r["ours_reaches_at"] != "never" else "never")
            out.append(f"| {r['line']} | {number(r['hv_evals'])} [{number(r['hv_evals_q1'])}, {number(r['hv_evals_q3'])}] | {small(r['p_evals'])} | "
                       f"{number(r['a12_evals'], 2)} | {'' if ours else verdict(r['p_evals'], r['a12_evals'])} | {number(r['hv_seconds'])} | "
                       f"{r['evaluations_at_seconds']:.0f} | {small(r['p_time'])} | {number(r['a12_time'], 2)} | "
                       f"{'' if ours else verdict(r['p_time'], r['a12_time'])} | {100 * r['feasible_children']:.0f} % | {reached} |")
        out.append("")
    return "\n".join(out)
