#!/bin/sh
# SPDX-License-Identifier: MIT
# Trains the coding of people on the motion files of the repository and writes
# gdextension/wire/src/coding/person_tables.hpp, the same bytes every time. With --left-out it only
# prints how well motion is coded that was not trained on. Needs a build (./run export).
set -eu
cd "$(dirname "$0")/../.."
poses=build/wire-poses.bin
output=${1:-gdextension/wire/src/coding/person_tables.hpp}
"${GODOT:-godot}" --headless --path . --script res://tools/wire/dump_poses.gd -- "$poses" \
	assets/motion/01_01.bvh assets/motion/01_03.bvh assets/motion/Boxing_Toes.bvh
cmake --build build/gdextension --target wire_train_models
build/gdextension/wire/wire_train_models "$poses" "$output"
