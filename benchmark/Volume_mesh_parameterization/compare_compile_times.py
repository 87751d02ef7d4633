#!/usr/bin/env python3
"""Compares the time and memory of the compiler for a map of a complex with those for other functions of CGAL."""
import argparse
import os
import pathlib
import shlex
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ENGINE = '-DCGAL_VOLUME_MESH_PARAMETERIZATION_COMPILED_ENGINE'
MESH_AND_MAP = ROOT / 'examples/Volume_mesh_parameterization/mesh_and_parameterize.cpp'
UNITS = [('types of a complex alone', 'types_only.cpp', []),
         ('ARAP `parameterize()` of a surface', 'map_of_surface.cpp', []),
         ('`make_mesh_3()`', 'mesh_of_surface.cpp', []),
         ('map of a complex, engine linked', 'map_of_complex.cpp', [ENGINE]),
         ('map of a complex, headers only', 'map_of_complex.cpp', []),
         ('map of arrays, engine linked', 'map_of_arrays.cpp', [ENGINE]),
         ('`make_mesh_3()` and map, engine linked', MESH_AND_MAP, [ENGINE])]


def compiled(command):
    """Returns the user seconds and the peak memory in GB of a compiler."""
    child = os.spawnvp(os.P_NOWAIT, command[0], command)
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        raise SystemExit('The compiler fails: ' + shlex.join(command))
    return usage.ru_utime, usage.ru_maxrss * 1024 / 1e9


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--compiler', default='g++')
    parser.add_argument('--flags', default='-std=c++17 -O3 -DNDEBUG -frounding-math -isystem /usr/include/eigen3')
    options = parser.parse_args()
    flags = ['-I' + str(ROOT / 'include'), '-DCGAL_EIGEN3_ENABLED', *shlex.split(options.flags)]
    print('| unit | user seconds | ratio | GB | ratio |\n|---|---:|---:|---:|---:|')
    with tempfile.TemporaryDirectory() as folder:
        first = None
        for name, unit, macros in UNITS:
            seconds, memory = compiled([options.compiler, *flags, *macros, '-c', str(HERE / 'compile_time' / unit),
                                        '-o', os.path.join(folder, 'unit.o')])
            first = first or (seconds, memory)
            print(f'| {name} | {seconds:.1f} | {seconds / first[0]:.1f} | {memory:.2f} | {memory / first[1]:.1f} |', flush=True)


if __name__ == '__main__':
    main()
