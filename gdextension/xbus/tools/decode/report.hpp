// SPDX-License-Identifier: MIT
#pragma once

#include "analysis.hpp"

#include <cstdio>

/// Everything, for programs: one JSON object. Its keys are documented in docs/xbus.md.
void write_json_report(const Recording &p_recording, const Analysis &p_analysis, std::FILE *p_file);

/// What it amounts to, for people.
void write_text_report(const Recording &p_recording, const Analysis &p_analysis, std::FILE *p_file);
