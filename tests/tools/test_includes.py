# SPDX-License-Identifier: MIT
"""The gate of includes in gdextension/, with made-up trees that break each of its rules."""

from __future__ import annotations

import pytest
from toolchain import includes
from toolchain.arrows import Order
from toolchain.includes import check

ORDER = Order.parse(
    """
    features: math < body
    body: base < joint gait < .
    """
)
SOUND = {
    "gdextension/math/src/quaternion.hpp": "#pragma once\n",
    "gdextension/body/src/base/vectors.hpp": "#include <quaternion.hpp>\n#include <vector>\n",
    "gdextension/body/src/joint/motor.hpp": '#include "base/vectors.hpp"\n',
    "gdextension/body/src/joint/motor.cpp": '#include "joint/motor.hpp"\n#include "muscle.hpp"\n',
    "gdextension/body/src/joint/muscle.hpp": "",
    "gdextension/body/src/gait/travel.hpp": '#include "base/vectors.hpp"\n',
    "gdextension/body/src/driver.hpp": '#include "joint/motor.hpp"\n#include "gait/travel.hpp"\n',
}


def test_a_sound_tree_has_no_faults() -> None:
    assert check(SOUND, ORDER) == []


@pytest.mark.parametrize(
    ("file", "text", "fault"),
    [
        ("body/src/base/a.hpp", '#include "joint/motor.hpp"', "base comes before joint"),
        ("body/src/gait/a.hpp", "#include <joint/motor.hpp>", "gait comes beside joint"),
        ("body/src/joint/a.hpp", '  #  include "driver.hpp"', "joint comes before ."),
        ("math/src/a.hpp", '#include "driver.hpp"', "math comes before body"),
        ("body/src/legs/a.hpp", "", "body/legs: 'legs' is not in a line 'body:'"),
        ("legs/src/a.hpp", "", "legs: it is not in the line 'features:'"),
        ("body/src/joint/muscle.hpp", '#include "motor.hpp"\n', ""),
    ],
)
def test_what_breaks_the_order_is_found(file: str, text: str, fault: str) -> None:
    found = check({**SOUND, f"gdextension/{file}": text}, ORDER)
    assert (fault in "\n".join(found)) if fault else found == []


def test_rings_of_folders_and_of_files_are_found() -> None:
    ring = {"gdextension/body/src/base/a.hpp": '#include "driver.hpp"'}
    assert any("folders in a ring: body" in fault for fault in check({**SOUND, **ring}, ORDER))
    ring = {"gdextension/body/src/joint/muscle.hpp": '#include "motor.cpp"'}
    (fault,) = check({**SOUND, **ring}, ORDER)
    assert fault.startswith("files in a ring: gdextension/body/src/joint/motor.cpp")


def test_comments_include_nothing() -> None:
    text = {"gdextension/body/src/base/a.hpp": '// #include "driver.hpp"'}
    assert check({**SOUND, **text}, ORDER) == []


def test_the_order_itself_can_be_read() -> None:
    assert Order.parse(includes.ORDER.read_text(encoding="utf-8")).tiers["features"]
