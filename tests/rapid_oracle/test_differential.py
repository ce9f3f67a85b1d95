"""driftpost's controller and the Python interpreter execute the same random programs; every motion must be the same.

Run from anywhere with `python -m unittest discover -s tests/rapid_oracle`; DRIFTPOST names the program under test.
"""

import os
import unittest
from concurrent.futures import ThreadPoolExecutor

from data import RapidError
from generator import program
from judged import compared, verdict
from lexer import Refused
from machine import Machine

PROGRAMS = 200


@unittest.skipUnless("DRIFTPOST" in os.environ, "DRIFTPOST does not name the program under test")
class Differential(unittest.TestCase):
    def test_random_programs_make_the_same_motions(self):
        with ThreadPoolExecutor() as pool:
            found = list(pool.map(lambda seed: compared(program(seed)), range(PROGRAMS)))
        differing = {seed: what for seed, what in enumerate(found) if what}
        self.assertEqual(differing, {})

    def noticed(self, fault):
        """Whether one of the programs differs when the Python interpreter is broken on purpose."""
        for seed in range(PROGRAMS):
            texts = program(seed)
            try:
                motions = Machine(*texts, faults=[fault]).started()
            except (Refused, RapidError, OverflowError):
                continue  # a broken machine may come to no end of its own; only a difference in the motions counts
            if verdict(texts, motions):
                return True
        return False

    def test_a_broken_interpreter_is_noticed(self):
        for fault in ("precedence", "for", "double", "inout", "test"):
            with self.subTest(fault):
                self.assertTrue(self.noticed(fault))


if __name__ == "__main__":
    unittest.main()
