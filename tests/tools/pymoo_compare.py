#!/usr/bin/env python3
"""Compares the search with pymoo's algorithms on our briefs: same evaluator, same starts, same archive filter.

  HOUSCAPER_SHARED=../shared python3 tests/tools/pymoo_compare.py run --binary target/release/houscaper --out /tmp/pymoo \\
      --plan starter=1000x20 two-storey=1000x20 go-design=500x10 --budget 3600
  python3 tests/tools/pymoo_compare.py table --out /tmp/pymoo --write results/search

Needs Python 3.11 with pymoo 0.6, moocore, scipy and numpy (pip install pymoo moocore scipy), and from $HOUSCAPER_SHARED/tools the file
pymoo_external.py, whose archive, label operators, duplicate filter and termination are used as they are.

Lines of the table
  ours                the default search: `houscaper optimize BRIEF --seed S`
  random, hill        `houscaper optimize --method random|hill`: our moves without selection, and as a hill climber
  generic/ALGORITHM   pymoo on labels and choices as integers: a random box of voxels swapped between two parents, labels changed at random
  repair/ALGORITHM    the same, each child repaired by `houscaper vary` ("op": "repair")
  own/ALGORITHM       pymoo's selection with our operators by `houscaper vary`: crossover for half of the children, then one to three moves,
                      or for one child in twenty (as the search does it) sections sized
ALGORITHM is NSGA-II, NSGA-III (reference directions by energy) or SMS-EMOA with a population of 50; ours keeps 50 parents. All begin with the
starts of the seed: pymoo with the first 50, ours with the first 64, of which the later ones may take over sections from the earlier.

Every run goes on until it has done its evaluations and used as much processor time as our run of the first seed (and a little more), so that both budgets can be
read off it. Time is processor time (user and system) of all processes of a run on one thread, from the first evaluation on: wall time on a
machine that others use would compare the others. One finished run is one file; started again, the script carries on.
"""
import argparse, bisect, datetime, json, os, platform, shutil, subprocess, sys, tempfile, time
from pathlib import Path

from pymoo_table import LINES, SPARE, write_table
from pymoo_variants import POPULATION, cpu_s, one_pymoo


def one_ours(args, method, brief, evals, seed, folder):
    """A run of the program on one thread; the wall times of its log become processor times by what is seen of the process on the way."""
    command = [args.binary, "optimize", brief, "--seed", str(seed), "--evaluations", str(evals), "--threads", "1", "--tables-only",
               "--out", str(folder)]
    with tempfile.TemporaryFile("w+") as errors:
        process = subprocess.Popen(command + ([] if method == "ours" else ["--method", method]), stdout=subprocess.DEVNULL, stderr=errors)
        seen = []                  # (wall time, processor time) from the moment on when the run folder is there and the search begins
        while process.poll() is None:
            if seen or (folder / "run.json").exists():
                try:
                    seen.append((time.perf_counter(), cpu_s(process.pid)))
                except (FileNotFoundError, ProcessLookupError):
                    break
            time.sleep(0.02)
        if process.wait() != 0:
            errors.seek(0)
            raise RuntimeError(f"{' '.join(command)}: {errors.read().strip()[-400:]}")
    written = json.loads((folder / "log.json").read_text())
    log, (wall, cpu) = written["log"], seen[0]
    for block in log:
        at_wall = wall + block["t"]
        i = min(max(bisect.bisect_left(seen, (at_wall,)), 1), len(seen) - 1)
        (w0, c0), (w1, c1) = seen[i - 1], seen[i]
        share = min(max((at_wall - w0) / (w1 - w0), 0.0), 1.0)
        block["t"] = c0 + share * (c1 - c0) - cpu
    children = [b for b in log if b["evals"] > POPULATION]
    counts = [len(b["f"]) for b in children], [b["infeasible"] for b in children]
    return dict(program="houscaper", version=written["version"], cpu_s=log[-1]["t"], evals=log[-1]["evals"],
                children=sum(counts[0]) + sum(counts[1]), feasible_children=sum(counts[0]), log=log)


def file_of(out, brief, line, seed):
    return Path(out) / brief / f"{line.replace('/', '_')}_{seed:02d}.json"


def run_one(args):
    brief, line, evals, seed = args.brief, args.line, args.evals, args.seed
    target = file_of(args.out, Path(brief).stem, line, seed)
    target.parent.mkdir(parents=True, exist_ok=True)
    if "/" in line:
        result = one_pymoo(args.binary, *line.split("/"), brief, evals, seed, args.seconds)
    else:
        folder = target.with_suffix(f".run{os.getpid()}")
        # Both baselines size no sections and go on, to have a value at the time that ours takes.
        result = one_ours(args, line, brief, evals if line == "ours" else 3 * evals // 2, seed, folder)
        shutil.rmtree(folder)
    result |= dict(line=line, brief=Path(brief).stem, seed=seed, planned=evals, date=datetime.date.today().isoformat(),
                   python=platform.python_version())
    part = target.with_suffix(".part")
    part.write_text(json.dumps(result))
    part.rename(target)


def run(args):
    """All runs that are not there yet, a seed of every line before the next seed, at most --jobs at once."""
    plan = []
    for text in args.plan:
        name, numbers = text.split("=")
        evals, seeds = (int(v) for v in numbers.split("x"))
        plan.append((str(Path(args.configs) / f"{name}.json"), evals, seeds))
    ended = time.time() + args.budget if args.budget else float("inf")
    # Whatever is there when the time is over is a balanced table: all lines of a seed, then the next, all briefs at the same share of theirs.
    ordered = sorted((seed / seeds, n, seed) for n, (_, _, seeds) in enumerate(plan) for seed in range(1, seeds + 1))
    tasks = [(plan[n][0], line, plan[n][1], seed) for _, n, seed in ordered for line in args.lines]
    running, failed = [], 0

    def seconds(brief):
        pilot = file_of(args.out, Path(brief).stem, "ours", 1)
        return SPARE * json.loads(pilot.read_text())["cpu_s"] if pilot.exists() else None

    while tasks or running:
        for process, task in running[:]:
            if process.poll() is not None:
                running.remove((process, task))
                failed += process.returncode != 0
                print(datetime.datetime.now().strftime("%H:%M:%S"), "done" if process.returncode == 0 else "FAILED", *task, flush=True)
        while tasks and len(running) < args.jobs and time.time() < ended and failed < 10:
            brief, line, evals, seed = tasks[0]
            if file_of(args.out, Path(brief).stem, line, seed).exists():
                tasks.pop(0)
                continue
            limit = 0 if "/" not in line else seconds(brief)
            if limit is None:      # the pilot, our own run of the first seed, is still running
                break
            tasks.pop(0)
            command = [sys.executable, __file__, "one", "--binary", args.binary, "--out", str(args.out), "--brief", brief, "--line", line,
                       "--evals", str(evals), "--seed", str(seed), "--seconds", str(limit)]
            running.append((subprocess.Popen(command), (brief, line, evals, seed)))
        if not running and (time.time() >= ended or failed >= 10):
            break
        time.sleep(0.05)
    print(f"{len(tasks)} runs left, {failed} failed")


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = p.add_subparsers(dest="command", required=True)
    r = commands.add_parser("run", help="make the runs that are missing")
    r.add_argument("--binary", required=True)
    r.add_argument("--configs", default="configs")
    r.add_argument("--out", required=True)
    r.add_argument("--plan", nargs="+", default=["starter=1000x20", "two-storey=1000x20", "go-design=500x10"], metavar="BRIEF=EVALSxSEEDS")
    r.add_argument("--lines", nargs="+", default=LINES, choices=LINES, metavar="LINE")
    r.add_argument("--budget", type=float, default=0, help="seconds after which no new run begins; 0: none")
    r.add_argument("--jobs", type=int, default=2, help="runs at once, each on one thread")
    o = commands.add_parser("one", help="one run")
    for name in ("binary", "out", "brief", "line"):
        o.add_argument(f"--{name}", required=True)
    o.add_argument("--evals", type=int, required=True)
    o.add_argument("--seed", type=int, required=True)
    o.add_argument("--seconds", type=float, default=0)
    t = commands.add_parser("table", help="CSV and Markdown of what is there")
    t.add_argument("--out", required=True)
    t.add_argument("--write", required=True, help="folder for pymoo.csv and pymoo.md")
    t.add_argument("--note", help="a sentence for the head of the table")
    args = p.parse_args()
    {"run": run, "one": run_one, "table": write_table}[args.command](args)


if __name__ == "__main__":
    main()
