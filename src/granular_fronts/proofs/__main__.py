"""Check certificates of fronts: python -m granular_fronts.proofs FILE ...."""

import sys

from granular_fronts.errors import end_with_reader
from granular_fronts.proofs.checker import check_certificate


def main(paths):
    """Print what each certificate proves; 1 if one proves nothing."""
    if not paths or "--help" in paths:
        print(__doc__)
        return 0 if paths else 2
    failed = 0
    for path in paths:
        record = check_certificate(path)
        failed |= not record["proved"]
        print(f"{path}: {'proved' if record['proved'] else 'not proved: ' + record['reason']}")
        for line in record["statements"]:
            print(f"  {line}")
        for found in record["inequalities"]:
            print(f"    {found['left']:.6g} < {found['right']:.6g}  {found['name']}")
    return int(failed)


if __name__ == "__main__":
    end_with_reader()
    sys.exit(main(sys.argv[1:]))
