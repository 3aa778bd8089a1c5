#!/usr/bin/env python3
import pathlib
import tempfile
import unittest

import check_includes


class CheckIncludes(unittest.TestCase):
    def faults(self, **files):
        """The faults in a tree of files, each given as path_with__for_slash="what it includes"."""
        with tempfile.TemporaryDirectory() as folder:
            for name, included in files.items():
                path = pathlib.Path(folder, name.replace("__", "/") + ".cc")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(f'#include <vector>\n#include "tautline/{included}"\n')
            return check_includes.check(pathlib.Path(folder))

    def test_leftwards_is_fine(self):
        self.assertEqual(self.faults(tautline__scene__a="geometry/polygon.h",
                                     tautline__scene__b="scene/scene.h",
                                     tautline__planners__tether__c="planners/tether/plan.h",
                                     apps__cli__main="draw/svg.h"), [])

    def test_rightwards_is_not(self):
        self.assertEqual(self.faults(tautline__geometry__a_test="scene/scene.h"),
                         ["tautline/geometry/a_test.cc:2: geometry must not include scene"])

    def test_planners_do_not_meet(self):
        self.assertEqual(self.faults(tautline__planners__fleet__a="planners/tether/plan.h"),
                         ["tautline/planners/fleet/a.cc:2: planners never include each other"])

    def test_unknown_folder(self):
        self.assertEqual(self.faults(apps__cli__main="utils/x.h"),
                         ["apps/cli/main.cc:2: utils is no folder of the table"])


if __name__ == "__main__":
    unittest.main()
