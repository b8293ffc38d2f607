// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>

namespace transport {

/// Which numbers of datagrams have come: of the newest SIZE exactly, older ones count as come.
class ReplayWindow {
public:
	static constexpr uint64_t SIZE = 2048;

	/// Whether a number may still come.
	bool is_new(uint64_t p_number) const {
		if (p_number >= _next) {
			return true;
		}
		return _next - p_number <= SIZE && !_come[p_number % SIZE];
	}

	/// A number has come.
	void note(uint64_t p_number) {
		if (p_number >= _next) {
			if (p_number - _next >= SIZE) {
				_come.reset();
			} else {
				for (uint64_t number = _next; number < p_number; number++) {
					_come[number % SIZE] = false;
				}
			}
			_next = p_number + 1;
		}
		_come[p_number % SIZE] = true;
	}

	/// One more than the newest number that has come.
	uint64_t next() const { return _next; }

private:
	std::bitset<SIZE> _come;
	uint64_t _next = 0;
};

} // namespace transport
