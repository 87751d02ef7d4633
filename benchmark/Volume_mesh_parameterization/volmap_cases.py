"""Finds the cases in a folder of the VOLMAP benchmark and in a folder of pairs of meshes."""
import re
from collections import namedtuple
from pathlib import Path

# `is_free`: the boundary is free where it has no target
Case = namedtuple("Case", "name source target is_free", defaults=[False])


def find_cases(volmap=None, pairs=None, pattern=""):
    """MODEL.mesh with MODEL_DOMAIN.txt, and NAME_source.mesh with NAME_polycube.mesh."""
    cases = []
    if volmap:
        for target in sorted(Path(volmap).glob("*_*.txt")):
            source = target.with_name(target.stem.rsplit("_", 1)[0] + ".mesh")
            if source.exists():
                cases.append(Case(target.stem, source, target))
    if pairs:
        for source in sorted(Path(pairs).glob("*_source.mesh")):
            name = source.stem[:-len("_source")]
            cases.append(Case(name + "_polycube", source, source.with_name(name + "_polycube.mesh")))
    return [case for case in cases if re.search(pattern, case.name)]


def add_case_options(parser):
    parser.add_argument("volmap", help="folder with MODEL.mesh and MODEL_DOMAIN.txt")
    parser.add_argument("--pairs", help="folder with NAME_source.mesh and NAME_polycube.mesh")
    parser.add_argument("--filter", default="", help="only cases whose name contains this regular expression")
