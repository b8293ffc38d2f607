// SPDX-License-Identifier: MIT
#pragma once

#include "replication/world_tick.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace wire {

/// An entity's fields at the last ticks at which they were put: on the server those at which they changed, at a
/// client those of which it was sent something. Memory is only taken when it is made.
class FieldHistory {
public:
	/// States that are kept.
	static constexpr std::size_t KEPT = 64;
	/// States are coded against others that are at most so many ticks older, or against older ones of which there
	/// is only one that can be meant.
	static constexpr uint32_t MAX_AGE = KEPT - 1;

	explicit FieldHistory(const std::vector<uint32_t> &p_spawn) :
			_count(p_spawn.size()), _spawn(p_spawn), _values(p_spawn.size() * KEPT) {
		_ticks.fill(NEVER);
	}

	/// Notes the fields at a tick, in place of those that were put first.
	void put(uint32_t p_tick, const uint32_t *p_values) {
		if (_ticks[_head] != p_tick) {
			_is_ordered = _is_ordered && (_ticks[_head] == NEVER || int32_t(p_tick - _ticks[_head]) > 0);
			_head = (_head + 1) % KEPT;
			_has_dropped = _has_dropped || _ticks[_head] != NEVER;
		}
		_ticks[_head] = p_tick;
		std::copy_n(p_values, _count, _values.begin() + std::ptrdiff_t(_head * _count));
	}
	/// The fields that were put at a tick; null if there are none (any more).
	const uint32_t *find(uint32_t p_tick) const {
		for (std::size_t ago = 0; ago < KEPT; ago++) {
			const std::size_t i = (_head + KEPT - ago) % KEPT;
			if (_ticks[i] == p_tick && p_tick != NEVER) {
				return &_values[i * _count];
			}
		}
		return nullptr;
	}
	/// The newest fields that were put at a tick or before; null if there are none (any more).
	const uint32_t *find_until(uint32_t p_tick) const {
		std::size_t best = KEPT;
		for (std::size_t ago = 0; ago < KEPT; ago++) {
			const std::size_t i = (_head + KEPT - ago) % KEPT;
			if (_ticks[i] != NEVER && int32_t(_ticks[i] - p_tick) <= 0 &&
					(best == KEPT || int32_t(_ticks[i] - _ticks[best]) > 0)) {
				best = i;
				if (_is_ordered) {
					break;
				}
			}
		}
		return best == KEPT ? nullptr : &_values[best * _count];
	}
	/// The fields as they were at a tick, if put() was called whenever they changed; null if that is not known any
	/// more.
	const uint32_t *in_force_at(uint32_t p_tick) const {
		const uint32_t *found = find_until(p_tick);
		return found != nullptr || _has_dropped ? found : _spawn.data();
	}
	const std::vector<uint32_t> &spawn() const { return _spawn; }

private:
	std::size_t _count;
	std::size_t _head = 0; // What was put last.
	bool _is_ordered = true; // All was put in the order of ticks.
	bool _has_dropped = false;
	std::vector<uint32_t> _spawn;
	std::vector<uint32_t> _values;
	std::array<uint32_t, KEPT> _ticks{};
};

} // namespace wire
