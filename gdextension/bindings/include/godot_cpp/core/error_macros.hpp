// SPDX-License-Identifier: MIT
#pragma once

// Checks at the border to scripts: they print an error with its file and line, and leave the function.
// Messages may be a const char *, a String, or anything else that a String is made from.

#include <godot_cpp/core/defs.hpp>

namespace godot {

class String;

/// Prints an error or a warning into the engine's log.
void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const char *p_message = "", bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const String &p_message, bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error,
		const char *p_message = "", bool p_editor_notify = false, bool p_is_warning = false);

} // namespace godot

// Leaves the function by `m_leave` when the condition holds.
#define GODOT_FAIL_IF(m_condition, m_error, m_message, m_leave) \
	if (unlikely(m_condition)) { \
		::godot::_err_print_error(__func__, __FILE__, __LINE__, m_error, m_message); \
		m_leave; \
	} else \
		((void)0)

#define GODOT_COND_TEXT(m_condition) "Condition \"" #m_condition "\" is true."
#define GODOT_NULL_TEXT(m_parameter) "Parameter \"" #m_parameter "\" is null."
#define GODOT_INDEX_TEXT(m_index, m_size) "Index " #m_index " is out of bounds (" #m_size ")."
#define GODOT_OUT_OF_BOUNDS(m_index, m_size) (int64_t(m_index) < 0 || int64_t(m_index) >= int64_t(m_size))

#define ERR_FAIL_COND(m_condition) ERR_FAIL_COND_MSG(m_condition, "")
#define ERR_FAIL_COND_MSG(m_condition, m_message) \
	GODOT_FAIL_IF(m_condition, GODOT_COND_TEXT(m_condition), m_message, return)
#define ERR_FAIL_COND_V(m_condition, m_result) ERR_FAIL_COND_V_MSG(m_condition, m_result, "")
#define ERR_FAIL_COND_V_MSG(m_condition, m_result, m_message) \
	GODOT_FAIL_IF(m_condition, GODOT_COND_TEXT(m_condition), m_message, return m_result)

#define ERR_FAIL_NULL(m_parameter) ERR_FAIL_NULL_MSG(m_parameter, "")
#define ERR_FAIL_NULL_MSG(m_parameter, m_message) \
	GODOT_FAIL_IF((m_parameter) == nullptr, GODOT_NULL_TEXT(m_parameter), m_message, return)
#define ERR_FAIL_NULL_V(m_parameter, m_result) ERR_FAIL_NULL_V_MSG(m_parameter, m_result, "")
#define ERR_FAIL_NULL_V_MSG(m_parameter, m_result, m_message) \
	GODOT_FAIL_IF((m_parameter) == nullptr, GODOT_NULL_TEXT(m_parameter), m_message, return m_result)

#define ERR_FAIL_INDEX(m_index, m_size) ERR_FAIL_INDEX_MSG(m_index, m_size, "")
#define ERR_FAIL_INDEX_MSG(m_index, m_size, m_message) \
	GODOT_FAIL_IF(GODOT_OUT_OF_BOUNDS(m_index, m_size), GODOT_INDEX_TEXT(m_index, m_size), m_message, return)
#define ERR_FAIL_INDEX_V(m_index, m_size, m_result) ERR_FAIL_INDEX_V_MSG(m_index, m_size, m_result, "")
#define ERR_FAIL_INDEX_V_MSG(m_index, m_size, m_result, m_message) \
	GODOT_FAIL_IF(GODOT_OUT_OF_BOUNDS(m_index, m_size), GODOT_INDEX_TEXT(m_index, m_size), m_message, return m_result)

#define ERR_FAIL() ERR_FAIL_MSG("")
#define ERR_FAIL_MSG(m_message) GODOT_FAIL_IF(true, "Method/function failed.", m_message, return)
#define ERR_FAIL_V(m_result) ERR_FAIL_V_MSG(m_result, "")
#define ERR_FAIL_V_MSG(m_result, m_message) \
	GODOT_FAIL_IF(true, "Method/function failed. Returning: " #m_result, m_message, return m_result)

#define ERR_CONTINUE(m_condition) ERR_CONTINUE_MSG(m_condition, "")
#define ERR_CONTINUE_MSG(m_condition, m_message) \
	GODOT_FAIL_IF(m_condition, GODOT_COND_TEXT(m_condition) " Continuing.", m_message, continue)

#define ERR_PRINT(m_message) ::godot::_err_print_error(__func__, __FILE__, __LINE__, m_message)
#define WARN_PRINT(m_message) ::godot::_err_print_error(__func__, __FILE__, __LINE__, m_message, "", false, true)
