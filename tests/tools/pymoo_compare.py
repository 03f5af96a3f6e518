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
ALGORITHM is NSGA-II, NSGA-III (reference directions by energy) or SMS-EMOA, population 50 (ours keeps 50 parents). All start from the same
houses: the first 50 starts of the seed, of which the search itself takes the first 64.

Every run goes on until it has done its evaluations and used as much processor time as our run of the first seed, so that both budgets can be
read off it. Time is processor time (user and system) of all processes of a run on one thread, from the first evaluation on: wall time on a
machine that others use would compare the others. One finished run is one file; started again, the script carries on.
"""
import argparse, bisect, csv, datetime, json, os, platform, shutil, subprocess, sys, tempfile, threading, time
from pathlib import Path

ALGORITHMS = ["nsga2", "nsga3", "smsemoa"]
LINES = ["ours", "random", "hill"] + [f"{v}/{a}" for v in ("generic", "repair", "own") for a in ALGORITHMS]
POPULATION = 50
STAIR = 5                      # genes of a stair: is there (0, 1), x, y, run, kind
RUNS, KINDS = ["+x", "+y", "-x", "-y"], ["straight", "u_turn"]
SPARE = 1.15                   # a run goes on for so many times the time of our first one: our median may be above it
MOST_OVERRUN = 40              # a run that has its evaluations ends at so many times their number, whatever its time


def shared_tool(name):
    root = Path(os.environ.get("HOUSCAPER_SHARED") or Path(__file__).absolute().parent / "../../../shared") / "tools"
    if not (root / f"{name}.py").exists():
        raise SystemExit(f"no {root / name}.py: set HOUSCAPER_SHARED to the folder of shared reference inputs")
    sys.path.insert(0, str(root))
    return __import__(name)


def cpu_s(pid):
    """Processor seconds of a running process, user and system."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Lines:
    """A process that answers batches of JSON lines in their order."""

    def __init__(self, command):
        environment = dict(os.environ, RAYON_NUM_THREADS="1")
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                        text=True, bufsize=1 << 20, env=environment)

    def ask(self, requests):
        if not requests:
            return []
        text = "".join(json.dumps(r, separators=(",", ":")) + "\n" for r in requests) + "\n"

        def feed():                # beside the reading: neither pipe may fill up while the other waits
            self.process.stdin.write(text)
            self.process.stdin.flush()
        feeder = threading.Thread(target=feed, daemon=True)
        feeder.start()
        answers = []
        while len(answers) < len(requests):
            line = self.process.stdout.readline()
            if not line:
                raise RuntimeError(f"{self.process.args}: ended after {len(answers)} of {len(requests)} answers")
            answers.append(json.loads(line))
        feeder.join()
        return answers

    def close(self):
        self.process.stdin.close()
        self.process.wait(timeout=60)


class Genome:
    """Labels, choices and stairs as one row of integers: labels, six choices, five genes per stair."""

    def __init__(self, space, np):
        self.np, self.shape = np, space["shape"]
        self.n = int(np.prod(self.shape))
        self.names = list(space["choices"])
        joists = 1 << space["storeys"][1]
        self.options = [joists if n == "joist_axes" else len(space["choices"][n]) for n in self.names]
        self.index = [{o: i for i, o in enumerate(space["choices"][n])} for n in self.names]
        self.stairs = max(space["storeys"][1] - 1, 0)
        self.length = self.n + len(self.names) + STAIR * self.stairs

    def read(self, answer):
        row = self.np.zeros(self.length, int)
        row[:self.n] = answer["labels"]
        for c, name in enumerate(self.names):
            value = answer["choices"][name]
            bits = sum(1 << p for p, axis in enumerate(value) if axis == "y") if name == "joist_axes" else self.index[c][value]
            row[self.n + c] = bits
        for stair in answer["stairs"]:
            at = self.n + len(self.names) + STAIR * stair["storey"]
            row[at:at + STAIR] = [1, *stair["start"], RUNS.index(stair["run"]), KINDS.index(stair["kind"])]
        return row

    def write(self, row):
        choices = {name: int(row[self.n + c]) for c, name in enumerate(self.names)}
        out = {"shape": self.shape, "labels": row[:self.n].tolist(), "choices": choices}
        stairs = []
        for s in range(self.stairs):
            there, x, y, run, kind = row[self.n + len(self.names) + STAIR * s:][:STAIR].tolist()
            if there:
                stairs.append({"storey": s, "start": [x, y], "run": RUNS[run], "kind": KINDS[kind]})
        if stairs:                 # left out, they are read from the voids of the plates
            out["stairs"] = stairs
        return out


def one_pymoo(args, variant, algorithm, brief, evals, seed, seconds):
    import numpy as np
    import moocore, pymoo
    from pymoo.core.crossover import Crossover
    from pymoo.core.mutation import Mutation
    from pymoo.core.problem import Problem
    from pymoo.core.repair import Repair
    from pymoo.core.sampling import Sampling
    from pymoo.optimize import minimize
    tool = shared_tool("pymoo_external")

    evaluator = Lines([args.binary, "evaluate", "--batch", "--genome", "--brief", brief])
    vary = Lines([args.binary, "vary", "--brief", brief])
    space = vary.ask([{"op": "space"}])[0]
    genome = Genome(space, np)
    starts = vary.ask([{"op": "start", "seed": seed, "stream": s} for s in range(POPULATION)])
    starts = np.array([genome.read(a) for a in starts if "error" not in a])

    def evaluated(rows):
        return evaluator.ask([{"id": i, **genome.write(row)} for i, row in enumerate(rows)])

    objectives = len(evaluated(starts[:1])[0]["f"])

    def used():
        return time.process_time() + cpu_s(evaluator.process.pid) + cpu_s(vary.process.pid)

    class Houses(Problem):
        def __init__(self):
            super().__init__(n_var=genome.length, n_obj=objectives, n_ieq_constr=1, xl=0, xu=max(max(genome.options), 64), vtype=int)
            self.shape3, self.n_labels = genome.shape, 6
            self.n, self.log, self.children, self.feasible = 0, [], 0, 0
            self.archive, self.t0, self.began = tool.Archive(objectives), None, used()

        def spent(self):
            return used() - self.began

        def done(self):
            late = self.n >= MOST_OVERRUN * evals
            return 1.0 if late else min(self.n / evals, self.spent() / seconds if seconds else 1.0)

        def _evaluate(self, X, out, *a, **k):
            X = np.asarray(X, int)
            answers = evaluated(X)
            F, CV = np.full((len(X), objectives), 1e9), np.full(len(X), 1e9)
            for i, answer in enumerate(answers):
                if "error" not in answer:
                    F[i], CV[i] = answer["f"], answer["cv"]
            ok = CV <= 0
            t = self.spent()
            # A batch is cut where the evaluations of the comparison are full.
            cuts = [0, evals - self.n, len(X)] if self.n < evals < self.n + len(X) else [0, len(X)]
            for a_, b_ in zip(cuts, cuts[1:]):
                part = F[a_:b_][ok[a_:b_]]
                self.log.append({"evals": self.n + b_, "t": t, "f": part.tolist(), "infeasible": int(b_ - a_ - len(part))})
            if self.n:
                self.children += len(X)
                self.feasible += int(ok.sum())
            self.n += len(X)
            self.archive.add(F[ok], X[ok])
            out["F"], out["G"] = F, CV[:, None]

    class Starts(Sampling):
        def _do(self, problem, n_samples, *a, **k):
            return starts[:n_samples]

    def seeds(rng, count):
        return [int(v) for v in rng.integers(0, 1 << 53, count)]

    labels_mutation, box = tool.LabelMutation(1.0), tool.BlockCrossover()
    head, tail = slice(0, genome.n), slice(genome.n, genome.n + len(genome.names))

    class GenericCrossover(Crossover):
        def __init__(self):
            super().__init__(2, 2, prob=0.9)

        def _do(self, problem, X, *a, random_state=None, **k):
            Y = np.array(X, int)
            Y[:, :, head] = box._do(problem, Y[:, :, head], random_state=random_state)
            swap = random_state.random(Y[0, :, tail].shape) < 0.5
            Y[0, :, tail], Y[1, :, tail] = np.where(swap, Y[1, :, tail], Y[0, :, tail]), np.where(swap, Y[0, :, tail], Y[1, :, tail])
            return Y

    class GenericMutation(Mutation):
        def _do(self, problem, X, *a, random_state=None, **k):
            Y = np.array(X, int)
            Y[:, head] = labels_mutation._do(problem, Y[:, head], random_state=random_state)
            other = np.column_stack([random_state.integers(0, o, len(Y)) for o in genome.options])
            drawn = random_state.random(other.shape) < 1.0 / len(genome.options)
            Y[:, tail] = np.where(drawn, other, Y[:, tail])
            Y[:, tail.stop:] = 0
            return Y

    class ByVary(Repair):
        def _do(self, problem, X, **k):
            Y = np.array(X, int)
            answers = vary.ask([{"op": "repair", "parents": [genome.write(row)]} for row in Y])
            for i, answer in enumerate(answers):
                if "error" not in answer:
                    Y[i] = genome.read(answer)
            return Y

    class OwnCrossover(Crossover):
        def __init__(self):
            super().__init__(2, 1, prob=1.0)

        def _do(self, problem, X, *a, random_state=None, **k):
            Y = np.array(X[:1], int)
            at = np.flatnonzero(random_state.random(Y.shape[1]) < 0.5)
            requests = [{"op": "crossover", "seed": s, "parents": [genome.write(X[0, i]), genome.write(X[1, i])]}
                        for i, s in zip(at, seeds(random_state, len(at)))]
            for i, answer in zip(at, vary.ask(requests)):
                if "error" not in answer:
                    Y[0, i] = genome.read(answer)
            return Y

    class OwnMutation(Mutation):
        def _do(self, problem, X, *a, random_state=None, **k):
            Y, requests = np.array(X, int), []
            for row, s in zip(Y, seeds(random_state, len(Y))):
                if random_state.random() < 0.05:
                    goal = space["goals"][random_state.integers(0, len(space["goals"]))]
                    requests.append({"op": "size", "goal": goal, "parents": [genome.write(row)]})
                else:
                    steps = [1, 1, 1, 2, 3][random_state.integers(0, 5)]
                    requests.append({"op": "move", "steps": steps, "seed": s, "parents": [genome.write(row)]})
            for i, answer in enumerate(vary.ask(requests)):
                if "error" not in answer:
                    Y[i] = genome.read(answer)
            return Y

    class Done(tool.Termination):
        def _update(self, run):
            return problem.done()

    settings = dict(sampling=Starts(), eliminate_duplicates=tool.HashDuplicates())
    if variant == "own":
        settings |= dict(crossover=OwnCrossover(), mutation=OwnMutation())
    else:
        settings |= dict(crossover=GenericCrossover(), mutation=GenericMutation())
        if variant == "repair":
            settings |= dict(repair=ByVary())
    if algorithm == "nsga2":
        from pymoo.algorithms.moo.nsga2 import NSGA2
        method = NSGA2(pop_size=POPULATION, **settings)
    elif algorithm == "nsga3":
        from pymoo.algorithms.moo.nsga3 import NSGA3
        from pymoo.util.ref_dirs import get_reference_directions
        method = NSGA3(ref_dirs=get_reference_directions("energy", objectives, POPULATION, seed=1), pop_size=POPULATION, **settings)
    else:
        from pymoo.algorithms.moo.sms import SMSEMOA
        method = SMSEMOA(pop_size=POPULATION, **settings)
    problem = Houses()             # the clock starts here: imports, books and reference directions are not counted
    minimize(problem, method, Done(), seed=seed, copy_algorithm=False, copy_termination=False)
    out = dict(program="pymoo", version=pymoo.__version__, moocore=moocore.__version__, cpu_s=problem.spent(), evals=problem.n,
               children=problem.children, feasible_children=problem.feasible, archive=len(problem.archive.F), log=problem.log)
    evaluator.close()
    vary.close()
    return out


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
        result = one_pymoo(args, *line.split("/"), brief, evals, seed, args.seconds)
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


# ---- the table ----

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


def at(c, column, x):
    return c[np_search(c[:, column], x), 2]


def np_search(values, x):
    return int((values <= x + 1e-9).sum()) - 1


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
                   evaluations_at_seconds=float(np.median([c[np_search(c[:, 1], seconds), 0] for c in curves[line]])))
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


def table(args):
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
    {"run": run, "one": run_one, "table": table}[args.command](args)


if __name__ == "__main__":
    main()
