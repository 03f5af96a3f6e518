#!/usr/bin/env python3
"""Recomputes the quotes of a run or a house from bom.csv and the books, with nothing but Python's own library.

    python3 tests/tools/requote.py results/starter [configs]

For every bom.csv below the folder: materials by the parts of the line's build-up (or the rate of the frame's material) less their labour and waste; waste
on the materials of the lines; labour by the hours of the rates; practice, set-up, trucks, crane and crew by the price book; each at low, default and
high, to 1e-9 of the amount. Where a quote.json lies beside it, every printed amount in cents, every surcharge on its base, and every total as the sum of
what is printed. Exit code 1 and a line for each difference.
"""

import csv
import json
import math
import sys
from collections import defaultdict
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

COLUMNS = ("amount_low", "amount", "amount_high")
KEYS = ("low", "default", "high")


def cents(value):
    return float(Decimal(repr(value)).quantize(Decimal("0.01"), ROUND_HALF_UP))


class Books:
    def __init__(self, configs):
        self.prices = json.loads((configs / "prices.json").read_text())
        builds = json.loads((configs / "buildups.json").read_text())
        self.item = {item["id"]: item for item in self.prices["items"]}
        self.surcharge = {rate["id"]: [rate[k] for k in KEYS] for rate in self.prices["rates"]}
        self.works = self.prices["works"]
        by_id = {b["id"]: b for b in builds["buildups"]}
        self.parts = {}
        for item, buildup in builds["uses"].items():
            layers = (part for layer in by_id[buildup]["layers"] for part in layer["parts"])
            self.parts[item] = [(p["item"], p["per_unit"]) for part in layers for p in part.get("price", [])]
        for frame in builds["frame"]:
            self.parts["frame_" + frame["material"].lower()] = [(frame["price"], 1.0)]

    def unit(self, item):
        """What stays at low, default, high; the same by share of waste; hours in the factory and on the plot; all per unit of an item of the bill."""
        stays, wasted, hours = [0.0] * 3, defaultdict(lambda: [0.0] * 3), [0.0, 0.0]
        for name, per_unit in self.parts[item]:
            price = self.item[name]
            worked = price.get("labour_h", 0.0)
            hours[price.get("work", "factory") == "site"] += per_unit * worked
            waste = price.get("waste", 0.0)
            for k, key in enumerate(KEYS):
                net = per_unit * (price[key] - worked * self.prices["labour_basis_eur_h"]) / (1.0 + waste)
                stays[k] += net
                if waste:
                    wasted[waste][k] += net
        return stays, wasted, hours

    def rate(self, item):
        return [self.item[item][key] for key in KEYS]


def mean(pieces, learning):
    """Mean time of a piece as a share of the first one's."""
    return sum(n ** math.log2(learning) for n in range(1, pieces + 1)) / pieces if pieces else 1.0


def expected(lines, books, practice):
    """Amounts of every line at low, default, high; None where the quote's own count of repetition is not at hand."""
    wasted, hours, amounts = defaultdict(lambda: [0.0] * 3), [0.0, 0.0], {}
    learning = [books.works["learning_" + k] for k in KEYS]
    for line in lines:
        quantity, item = float(line["quantity"]), line["item"]
        if item in books.parts:
            stays, waste, worked = books.unit(item)
            amounts[line["line"]] = [quantity * rate for rate in stays]
            for share, base in waste.items():
                wasted[share] = [a + quantity * b for a, b in zip(wasted[share], base)]
            hours = [a + quantity * b for a, b in zip(hours, worked)]
    found = {line["item"]: line for line in lines}
    count = lambda item: float(found[item]["quantity"]) if item in found else 0.0
    carried = sum(float(line["mass_kg"]) for line in lines if line["group"] != "foundation")
    times = lambda quantity, item: [quantity * rate for rate in books.rate(item)]
    labour = times(hours[0], "labour_hour")
    left = [None] * 3
    if practice:
        area = practice["repeated_m2"]
        whole = sum(area)
        left[0] = [sum(a * mean(n + 1, rate) for n, a in enumerate(area)) / whole if whole else 1.0 for rate in learning]
    left[1] = [mean(round(count("setup_parts")), rate) for rate in learning]
    left[2] = [mean(round(count("setup_nodes")), rate) for rate in learning]
    saved = lambda base, share: None if share is None else [b * (s - 1.0) for b, s in zip(base, share)]
    trips, crane = count("truck_trips"), count("crane")
    works = {
        "factory_labour": labour,
        "learning_labour": saved(labour, left[0]),
        "setup_parts": times(count("setup_parts"), "setup_part"),
        "learning_parts": saved(times(count("setup_parts"), "setup_part"), left[1]),
        "setup_nodes": times(count("setup_nodes"), "setup_node"),
        "learning_nodes": saved(times(count("setup_nodes"), "setup_node"), left[2]),
        "site_labour": times(hours[1], "labour_hour"),
        "truck_km": times(2.0 * books.works["distance_km"] * trips, "truck_km"),
        "truck_trips": times(trips, "truck_trip"),
        "crane": times(crane, "crane_day"),
        "assembly": times(crane * books.works["hours_per_day"] * books.works["crew"], "labour_hour"),
    }
    for line in lines:
        if line["item"] == "waste":
            share = float(line["quantity"])
            amounts[line["line"]] = [share * base for base in wasted.pop(share)]
        elif line["item"] in works:
            amounts[line["line"]] = works[line["item"]]
    if wasted:
        raise SystemExit(f"waste without a line: {dict(wasted)}")
    if trips and trips * books.works["payload_kg"] < carried:
        raise SystemExit(f"{trips} trips for {carried} kg")
    return amounts


def check(path, books):
    faults = []

    def near(name, ours, theirs, tolerance):
        if abs(ours - theirs) > tolerance:
            faults.append(f"{path}: {name}: {theirs}, by hand {ours}")

    with open(path, newline="") as file:
        lines = list(csv.DictReader(file))
    beside = path.with_name("quote.json")
    quote = json.loads(beside.read_text()) if beside.is_file() else None
    amounts = expected(lines, books, quote and quote["practice"])
    for line in lines:
        if amounts[line["line"]] is None:
            continue
        for amount, column in zip(amounts[line["line"]], COLUMNS):
            near(f"line {line['line']} {column}", amount, float(line[column]), 1e-9 * max(abs(amount), 1.0))
    if quote:
        for k, column in enumerate(COLUMNS):
            printed = [printed_line[column] for printed_line in quote["lines"]]
            for line, shown in zip(lines, printed, strict=True):
                # Half a cent may fall to either side where the amount is a tie to the last bit.
                near(f"line {line['line']} {column} in cents", cents(float(line[column])), shown, 0.0101)
                near(f"line {line['line']} {column} rounded", float(line[column]), shown, 0.005 + 1e-6)
            total = cents(sum(printed))
            near(f"subtotal {column}", total, quote["subtotal"][k], 1e-6)
            steps = [("surcharges", "price_eur"), ("further", "total")]
            for list_name, total_name in steps:
                for surcharge in quote[list_name]:
                    amount = cents(total * books.surcharge[surcharge["id"]][k])
                    near(f"{surcharge['id']} {column}", amount, surcharge[column], 0.0101)
                    total = cents(total + surcharge[column])
                near(f"{total_name} {column}", total, quote[total_name][k], 1e-6)
    return faults


def main():
    folder = Path(sys.argv[1])
    configs = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).resolve().parents[2] / "configs"
    books = Books(configs)
    bills = sorted(folder.rglob("bom.csv"))
    faults = [fault for path in bills for fault in check(path, books)]
    print("\n".join(faults[:20] + [f"{len(bills)} bills, {len(faults)} differences"]))
    sys.exit(1 if faults or not bills else 0)


main()
