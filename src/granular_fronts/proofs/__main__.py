"""Check certificates of fronts, with python-flint and NumPy alone.

python -m granular_fronts.proofs FILE ...           Each certificate by itself.

python -m granular_fronts.proofs --family FOLDER    All certificates there as one family in γ.

python -m granular_fronts.proofs --critical 3/2 2   Enclosures of the critical damping γ_x(α).
"""

import sys
from fractions import Fraction

from granular_fronts.errors import end_with_reader
from granular_fronts.proofs.balls import NotProvedError, in_a_sentence, in_balls
from granular_fronts.proofs.checker import check_certificate
from granular_fronts.proofs.families import certificates_below, conclude, prove_family
from granular_fronts.proofs.tail_roots import critical_damping

PRECISION, DIGITS = 160, 29  # bits of balls, and digits, of the critical damping


def main(words):
    """Print what is proved; 1 if something is not."""
    commands = {"--family": check_family, "--critical": print_critical_damping}
    if hasattr(sys.stdout, "reconfigure"):  # Consoles without Greek letters get their numbers.
        sys.stdout.reconfigure(errors="backslashreplace")
    if not words or {"-h", "--help"} & set(words):
        print(__doc__)
        return 0 if words else 2
    if words[0] in commands and len(words) == 1:
        print(f"{words[0]} needs something to check: see --help.")
        return 2
    run = commands.get(words[0], check_file)
    proved = [run(word) for word in words[words[0] in commands :]]
    return int(not all(proved))


def check_file(path):
    """Print what one certificate proves, and from which inequalities; whether it does."""
    record = check_certificate(path)
    print(f"{path}: {'proved' if record['proved'] else 'not proved: ' + record['reason']}")
    for line in record["statements"]:
        print(f"  {line}")
    for found in record["inequalities"]:
        print(f"    {found['left']:.6g} < {found['right']:.6g}  {found['name']}")
    return record["proved"]


def check_family(folder):
    """Print what the certificates of a folder prove together; whether they are a family."""
    records = []
    try:
        for record in prove_family(certificates_below(folder)):
            joined = ", joined to the one before" if records else ""
            print(f"{record['path']}: proved{joined}", flush=True)
            records.append(record)
        statements = list(conclude(records))
    except NotProvedError as failure:
        print(f"{folder}: not proved: {failure}")
        return False
    for line in statements:
        print(f"  {line}")
    return True


def print_critical_damping(alpha):
    """Print γ_x of one exponent; whether it is proved."""
    try:
        with in_balls(PRECISION), in_a_sentence(f"alpha = {alpha}: "):
            print(
                f"alpha = {alpha}: gamma_x = {critical_damping(Fraction(alpha)).gamma.str(DIGITS)}"
            )
    except NotProvedError as failure:
        print(f"not proved: {failure}")
        return False
    return True


if __name__ == "__main__":
    end_with_reader()
    sys.exit(main(sys.argv[1:]))
