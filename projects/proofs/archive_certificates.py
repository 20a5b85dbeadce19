"""Put all certificates of fronts into one archive, with the SHA-256 sum of each.

The archive has the same bytes wherever it is made from the same certificates.
"""

import hashlib
import io
import tarfile
from pathlib import Path

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import complete_file
from job import job

SUMS = "SHA256SUMS"  # checked by: sha256sum -c SHA256SUMS


def archive_certificates(fronts: str, intervals: str, folder: str, archive: str, sums: str) -> None:
    """Archive the certificates that two datasets name.

    Parameters
    ----------
    fronts, intervals : str
        Written by prove_fronts and join_intervals.
    folder : str
        All certificates lie in folders inside it, one for each family, as in the archive.
    archive : str
        The tar file to write: certificates are compressed already.
    sums : str
        The sums again, in a file next to the archive.
    """
    known = (read_dataset(path)["file"].values for path in (fronts, intervals))
    files = sorted(Path(str(file)) for part in known for file in part)
    members = {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}
    lines = (f"{hashlib.sha256(data).hexdigest()}  {name}\n" for name, data in members.items())
    text = "".join(lines).encode()
    with complete_file(sums) as unfinished:
        unfinished.write_bytes(text)
    with complete_file(archive) as unfinished, tarfile.open(unfinished, "w") as tar:
        for name, data in ({SUMS: text} | members).items():
            member = tarfile.TarInfo(name)
            member.size = len(data)
            tar.addfile(member, io.BytesIO(data))


if __name__ == "__main__":
    with job(snakemake):
        archive_certificates(
            snakemake.input.fronts,
            snakemake.input.intervals,
            snakemake.params.folder,
            snakemake.output.archive,
            snakemake.output.sums,
        )
