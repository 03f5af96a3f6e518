#!/usr/bin/env python3
"""Recomputes the quotes of a run or a house from bom.csv and the books, with nothing but Python's own library.

    python3 tests/tools/requote.py results/starter [configs]

For every bom.csv below the folder: rate = sum over the parts of the line's build-up (or the rate of the frame's material), amount = quantity x rate at
low, default and high, to 1e-9 of the amount; and, where a quote.json lies beside it, every printed amount in cents, every surcharge on its
base, and every total as the sum of what is printed. Exit code 1 and a line for each difference.
"""

import csv
import json
import sys
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path


def cents(value):
    return float(Decimal(repr(value)).quantize(Decimal("0.01"), ROUND_HALF_UP))


def rates(configs):
    """(low, default, high) of every item of the take-off."""
    prices = json.loads((configs / "prices.json").read_text())
    book = {item["id"]: [item[k] for k in ("low", "default", "high")] for item in prices["items"]}
    builds = json.loads((configs / "buildups.json").read_text())
    by_id = {b["id"]: b for b in builds["buildups"]}
    found = {}
    for item, buildup in builds["uses"].items():
        sums = [0.0, 0.0, 0.0]
        for layer in by_id[buildup]["layers"]:
            for part in layer["parts"]:
                for price in part.get("price", []):
                    for k in range(3):
                        sums[k] += price["per_unit"] * book[price["item"]][k]
        found[item] = sums
    for frame in builds["frame"]:
        found["frame_" + frame["material"].lower()] = book[frame["price"]]
    surcharges = {rate["id"]: [rate[k] for k in ("low", "default", "high")] for rate in prices["rates"]}
    return found, surcharges


def check(path, found, surcharges):
    faults = []

    def near(name, ours, theirs, tolerance):
        if abs(ours - theirs) > tolerance:
            faults.append(f"{path}: {name}: {theirs}, by hand {ours}")

    with open(path, newline="") as file:
        lines = list(csv.DictReader(file))
    columns = ("amount_low", "amount", "amount_high")
    for line in lines:
        for k, column in enumerate(columns):
            amount = float(line["quantity"]) * found[line["item"]][k]
            near(f"line {line['line']} {column}", amount, float(line[column]), 1e-9 * abs(amount))
    beside = path.with_name("quote.json")
    if beside.is_file():
        quote = json.loads(beside.read_text())
        sums = []
        for k, column in enumerate(columns):
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
                    amount = cents(total * surcharges[surcharge["id"]][k])
                    near(f"{surcharge['id']} {column}", amount, surcharge[column], 0.0101)
                    total = cents(total + surcharge[column])
                near(f"{total_name} {column}", total, quote[total_name][k], 1e-6)
            sums.append(total)
    return faults


def main():
    folder = Path(sys.argv[1])
    configs = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).resolve().parents[2] / "configs"
    found, surcharges = rates(configs)
    bills = sorted(folder.rglob("bom.csv"))
    faults = [fault for path in bills for fault in check(path, found, surcharges)]
    print("\n".join(faults[:20] + [f"{len(bills)} bills, {len(faults)} differences"]))
    sys.exit(1 if faults or not bills else 0)


main()
