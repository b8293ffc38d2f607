// SPDX-License-Identifier: MIT
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const char *p_message, bool p_editor_notify, bool p_is_warning) {
	const internal::EngineInterface &engine = internal::engine;
	const auto print = p_is_warning ? engine.print_warning_with_message : engine.print_error_with_message;
	print(p_error, p_message, p_function, p_file, p_line, p_editor_notify);
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const String &p_message, bool p_editor_notify, bool p_is_warning) {
	const CharString message = p_message.utf8();
	_err_print_error(p_function, p_file, p_line, p_error, message.get_data(), p_editor_notify, p_is_warning);
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error,
		const char *p_message, bool p_editor_notify, bool p_is_warning) {
	const CharString error = p_error.utf8();
	_err_print_error(p_function, p_file, p_line, error.get_data(), p_message, p_editor_notify, p_is_warning);
}

} // namespace godot
