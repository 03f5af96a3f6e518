"""pymoo on houses: the genome as integers, and what the generic, the repaired and our own operators do to it. See pymoo_compare.py."""
import json, os, subprocess, sys, threading, time
from pathlib import Path

POPULATION = 50
STAIR = 5                      # genes of a stair: is there (0, 1), x, y, run, kind
RUNS, KINDS = ["+x", "+y", "-x", "-y"], ["straight", "u_turn"]
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


def one_pymoo(binary, variant, algorithm, brief, evals, seed, seconds):
    import numpy as np
    import moocore, pymoo
    from pymoo.core.crossover import Crossover
    from pymoo.core.mutation import Mutation
    from pymoo.core.problem import Problem
    from pymoo.core.repair import Repair
    from pymoo.core.sampling import Sampling
    from pymoo.optimize import minimize
    tool = shared_tool("pymoo_external")

    evaluator = Lines([binary, "evaluate", "--batch", "--genome", "--brief", brief])
    vary = Lines([binary, "vary", "--brief", brief])
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
