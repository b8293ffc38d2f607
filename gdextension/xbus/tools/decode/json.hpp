// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

/// Writes JSON as it goes; commas come by themselves. Numbers keep all their digits; what is not finite is null.
class JsonWriter {
public:
	explicit JsonWriter(std::FILE *p_file) : _file(p_file) {}
	JsonWriter(const JsonWriter &) = delete;
	JsonWriter &operator=(const JsonWriter &) = delete;
	~JsonWriter() { flush(); }

	void begin_object() { _begin('{'); }
	void end_object() { _end('}'); }
	void begin_list() { _begin('['); }
	void end_list() { _end(']'); }

	void key(std::string_view p_key) {
		_comma();
		_quote(p_key);
		_text += ':';
		_first = true;
	}
	void value(std::string_view p_value) {
		_comma();
		_quote(p_value);
	}
	void value(const char *p_value) { value(std::string_view(p_value)); }
	void value(bool p_value) {
		_comma();
		_text += p_value ? "true" : "false";
	}
	void value(double p_value) {
		_comma();
		if (!std::isfinite(p_value)) {
			_text += "null";
			return;
		}
		_number(p_value);
	}
	void value(int64_t p_value) {
		_comma();
		_number(p_value);
	}
	void value(uint64_t p_value) {
		_comma();
		_number(p_value);
	}
	void value(int p_value) { value(int64_t(p_value)); }
	void value(unsigned p_value) { value(uint64_t(p_value)); }
	void null() {
		_comma();
		_text += "null";
	}
	template <class T>
	void member(std::string_view p_key, const T &p_value) {
		key(p_key);
		value(p_value);
	}
	/// A line's end between members, for people.
	void new_line() { _text += '\n'; }
	void flush() {
		std::fwrite(_text.data(), 1, _text.size(), _file);
		_text.clear();
	}

private:
	static constexpr std::size_t FULL = 65536;

	void _begin(char p_mark) {
		_comma();
		_text += p_mark;
		_first = true;
	}
	void _end(char p_mark) {
		_text += p_mark;
		_first = false;
	}
	void _comma() {
		if (!_first) {
			_text += ',';
		}
		_first = false;
		if (_text.size() > FULL) {
			flush();
		}
	}
	template <class T>
	void _number(T p_value) {
		char digits[40];
		const std::to_chars_result end = std::to_chars(digits, digits + sizeof(digits), p_value);
		_text.append(digits, end.ptr);
	}
	void _quote(std::string_view p_text) {
		_text += '"';
		for (const char letter : p_text) {
			if (letter == '"' || letter == '\\') {
				_text += '\\';
				_text += letter;
			} else if (uint8_t(letter) < 0x20 || uint8_t(letter) == 0x7F) {
				char code[8];
				std::snprintf(code, sizeof(code), "\\u%04x", unsigned(uint8_t(letter)));
				_text += code;
			} else {
				_text += letter;
			}
		}
		_text += '"';
	}

	std::FILE *_file;
	std::string _text;
	bool _first = true;
};
