"""Exported C libraries, compiled and called through ctypes."""

import ctypes
import subprocess

import numpy as np

FLAGS = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off")
TABLES = ("parameter", "start", "state", "output", "input", "pair")


def compile_c(folder, *sources, compiler="gcc", flags=(), shared=None):
    """Compile C files of a folder; return the program, or the shared library of that name."""
    target = folder / (shared or "program")
    kind = ("-shared", "-fPIC") if shared else ()
    command = [compiler, *FLAGS, *flags, *kind, "-o", str(target), *(str(folder / name) for name in sources), "-lm"]
    made = subprocess.run(command, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    return target


class Contact(ctypes.Structure):
    _fields_ = [
        *((name, ctypes.c_int) for name in ("count", "touching")),
        *((name, ctypes.c_double) for name in ("begin", "end", "approach_speed", "largest_force")),
    ]


class Library:
    """Simulations of an exported library."""

    def __init__(self, file, name):
        self.loaded, self.prefix, self.folder = ctypes.CDLL(str(file)), name, file.parent
        self.size = self.function("size", ctypes.c_size_t)()

    def function(self, name, result=ctypes.c_int):
        found = getattr(self.loaded, f"{self.prefix}_{name}")
        found.restype = result
        return found

    def count(self, table):
        unit = self.function("unit", ctypes.c_char_p)
        return next(i for i in range(10_000) if unit(TABLES.index(table), i) is None)

    def names(self, table):
        name = self.function("name", ctypes.c_char_p)
        return [name(TABLES.index(table), i).decode() for i in range(self.count(table))]

    def find(self, table, name):
        return self.function("find")(TABLES.index(table), name.encode())

    def simulation(self, **parameters):
        return Simulation(self, parameters)


class Simulation:
    def __init__(self, library, parameters):
        self.library = library
        self.memory = (ctypes.c_double * (library.size // 8 + 1))()
        assert library.function("create", ctypes.c_void_p)(self.memory, ctypes.c_size_t(ctypes.sizeof(self.memory)))
        for name, value in parameters.items():
            assert self("set_parameter", library.find("parameter", name), float(value)) == 0

    def __call__(self, name, *arguments):
        given = [ctypes.c_double(x) if isinstance(x, float) else x for x in arguments]
        return self.library.function(name)(self.memory, *given)

    def run(self, duration, ends=None, stop=0):
        code = self("start", float(duration))
        for t in ends if ends is not None else [duration]:
            if code < 0:
                break
            code = self("advance", float(t), stop)
        return code

    @property
    def time(self):
        return self.library.function("time", ctypes.c_double)(self.memory)

    def vector(self, name):
        found = np.zeros(self.library.count(name.removesuffix("s")))
        assert self(name, found.ctypes.data_as(ctypes.c_void_p)) == 0
        return found

    def counts(self):
        found = np.zeros(3)
        self("counts", found.ctypes.data_as(ctypes.c_void_p))
        return found

    def latest(self, pair=0):
        found = Contact()
        assert self("latest", pair, ctypes.byref(found)) == 0
        return found

    def text(self, code):
        return self.library.function("text", ctypes.c_char_p)(code).decode()
