// SPDX-License-Identifier: MIT
#pragma once

#include "coding/fixed_tables.hpp"
#include "coding/lattice_rotation.hpp"
#include "coding/number_model.hpp"
#include "coding/person_model.hpp"

namespace wire {

/// What writer and reader of a person share: predictions, and how sure they are.
struct PersonContext {
	const PersonModel &model;
	const uint16_t (*shares)[SHARE_POINTS]; ///< The distributions that the model names.
	const kinematics::Skeleton &skeleton;
	int resolution;
	const PersonState *base; ///< May be null.
	const PersonState *before; ///< May be null.
	int base_age; ///< Ticks.
	int velocity_age; ///< Ticks from before to base, above 0.
};

/// Codes a person through a port: NumberWriter, NumberReader, or one that counts.
template <class Port>
class PersonCoder {
public:
	PersonCoder(Port &p_port, const PersonContext &p_context) : _port(p_port), _context(p_context) {}

	/// Writes the state, or reads it. False if that is no state.
	bool code(PersonState &r_state) {
		bool same = _context.base != nullptr && _is_base(r_state);
		if (_context.base != nullptr && !_port.bit(CHANGED, same)) {
			return false;
		}
		if (same) {
			r_state = *_context.base;
			return true;
		}
		return code_changed(r_state);
	}
	/// The same for a state that is not the base.
	bool code_changed(PersonState &r_state) {
		if (!_code_root(r_state)) {
			return false;
		}
		for (std::size_t i = 0; i < std::size_t(_context.skeleton.limb_count); i++) {
			if (!_code_limb(i, r_state.limbs[i])) {
				return false;
			}
		}
		return true;
	}

private:
	static constexpr int64_t MAX_ROOT = int64_t(1) << 29;
	static constexpr int64_t MAX_MOTION = int64_t(1) << 18;
	static constexpr int64_t MAX_ERROR = int64_t(1) << 20;
	static constexpr int SQUARE_FLOOR = 256; // A unit, squared.
	static constexpr int MAX_SURPRISE = 64; // Four octaves.
	static constexpr uint32_t SAME_CHART = 65400;
	static constexpr uint32_t CHANGED = 65000;

	struct Triple {
		std::array<int64_t, 3> from{}; ///< Where the base is, 1 / FRACTION units.
		std::array<int64_t, 3> motion{}; ///< How far the velocity would take it.
		std::array<int64_t, 3> numbers{}; ///< What is coded.
		int step = 1; ///< Of the second and third number, which are as even or odd as the first.
		int limb_class = 0;
		bool usual_chart = true;
		std::array<int64_t, 3> pull{}; ///< How far the parent turned unexpectedly, 1 / FRACTION units.
		std::array<int64_t, 3> error{}; ///< Found out: how far this is from what was expected.
		int parent_surprise = 0;
	};

	// What a reader has so far does not matter: it is given.
	bool _is_base(const PersonState &p_state) const {
		bool equal = p_state.root == _context.base->root;
		for (std::size_t i = 0; i < std::size_t(_context.skeleton.limb_count); i++) {
			equal = equal && p_state.limbs[i] == _context.base->limbs[i];
		}
		return equal;
	}
	// Limits keep all products within 64 bits.
	static int64_t _limited(int64_t p_value, int64_t p_most) {
		return p_value < -p_most ? -p_most : (p_value > p_most ? p_most : p_value);
	}
	// Nearly all have 32 bits, which are divided in a third of the time.
	static int64_t _quotient(int64_t p_value, int64_t p_by) {
		const bool is_short = p_value == int32_t(p_value) && p_by == int32_t(p_by) && p_by > 0;
		return is_short ? int32_t(p_value) / int32_t(p_by) : p_value / p_by;
	}
	int64_t _moved(int64_t p_difference) const {
		return _limited(_quotient(p_difference * _context.base_age, _context.velocity_age), MAX_MOTION);
	}

	bool _code_root(PersonState &r_state) {
		Triple triple;
		for (std::size_t i = 0; i < 3; i++) {
			triple.numbers[i] = r_state.root[i];
			triple.from[i] = _context.base != nullptr ? int64_t(_context.base->root[i]) * FRACTION : 0;
			if (_context.base != nullptr && _context.before != nullptr) {
				triple.motion[i] = _moved((int64_t(_context.base->root[i]) - _context.before->root[i]) * FRACTION);
			}
		}
		int surprise = 0;
		if (!_code_triple(_context.model.root, triple, surprise)) {
			return false;
		}
		for (std::size_t i = 0; i < 3; i++) {
			if (triple.numbers[i] < -MAX_ROOT || triple.numbers[i] > MAX_ROOT) {
				return false;
			}
			r_state.root[i] = int32_t(triple.numbers[i]);
		}
		return true;
	}

	bool _code_chart(const RotationCode *p_base, uint8_t &r_dropped) {
		uint32_t dropped = r_dropped;
		bool other = p_base != nullptr && p_base->dropped != r_dropped;
		if (p_base != nullptr && !_port.bit(SAME_CHART, other)) {
			return false;
		}
		if (p_base != nullptr && !other) {
			r_dropped = p_base->dropped;
			return true;
		}
		if (!_port.bits(2, dropped)) {
			return false;
		}
		r_dropped = uint8_t(dropped);
		return true;
	}

	bool _code_limb(std::size_t p_limb, RotationCode &r_code) {
		const RotationCode *base = _context.base != nullptr ? &_context.base->limbs[p_limb] : nullptr;
		if (!_code_chart(base, r_code.dropped)) {
			return false;
		}
		Triple triple;
		triple.step = 2;
		triple.limb_class = _class_of(p_limb);
		triple.usual_chart = r_code.dropped == USUAL_CHART;
		const int parent = _context.skeleton.parents[p_limb];
		triple.parent_surprise = parent >= 0 ? _surprises[std::size_t(parent)] : _average;
		_predict(p_limb, r_code.dropped, triple);
		if (parent >= 0 && triple.usual_chart) {
			triple.pull = _turns[std::size_t(parent)];
		}
		for (std::size_t i = 0; i < 3; i++) {
			triple.numbers[i] = r_code.parts[i];
		}
		if (!_code_triple(_context.model.rotation, triple, _surprises[p_limb])) {
			return false;
		}
		_hand_on(triple, _turns[p_limb]);
		std::array<int32_t, 3> parts{};
		for (std::size_t i = 0; i < 3; i++) {
			if (triple.numbers[i] < -_context.resolution || triple.numbers[i] > _context.resolution) {
				return false;
			}
			parts[i] = int32_t(triple.numbers[i]);
			r_code.parts[i] = int16_t(triple.numbers[i]);
		}
		return is_on_lattice(parts, _context.resolution);
	}

	void _predict(std::size_t p_limb, int p_dropped, Triple &r_triple) const {
		if (_context.base == nullptr) {
			return;
		}
		const Parts from = parts_in_chart(_context.base->limbs[p_limb], p_dropped, _context.resolution);
		Parts older = from;
		if (_context.before != nullptr) {
			older = parts_in_chart(_context.before->limbs[p_limb], p_dropped, _context.resolution);
		}
		for (std::size_t i = 0; i < 3; i++) {
			r_triple.from[i] = from[i];
			r_triple.motion[i] = _moved(from[i] - older[i]);
		}
	}

	// What a limb passes on to its children: how far it turned unexpectedly.
	void _hand_on(const Triple &p_triple, std::array<int64_t, 3> &r_turn) const {
		if (!p_triple.usual_chart || _context.base == nullptr) {
			return;
		}
		const int64_t share = _context.model.rotation.passes[p_triple.limb_class];
		for (std::size_t i = 0; i < 3; i++) {
			r_turn[i] = _limited(p_triple.error[i] + p_triple.pull[i] * share / 256, MAX_ERROR);
		}
	}

	int _class_of(std::size_t p_limb) const {
		return _context.skeleton.limb_count == 16 ? CLASS_OF_LIMB[p_limb] : LIMB_CLASSES - 1;
	}

	bool _code_triple(const MotionModel &p_model, Triple &r_triple, int &r_surprise) {
		const std::array<int64_t, 3> &motion = r_triple.motion;
		const int64_t square = motion[0] * motion[0] + motion[1] * motion[1] + motion[2] * motion[2];
		const int speed = _half_log16(square);
		const int64_t gain = p_model.gains[_gain_step(speed)];
		const int common = 64 * p_model.biases[r_triple.limb_class] + p_model.speed * speed +
				p_model.parent * r_triple.parent_surprise + p_model.average * _average;
		int64_t along = 0; // The errors so far, along the velocity.
		int64_t weight = square * p_model.along / 256 + SQUARE_FLOOR;
		int surprise = 0;
		int total = 0;
		for (std::size_t i = 0; i < 3; i++) {
			const int64_t expected = r_triple.from[i] + motion[i] * gain / 256 +
					r_triple.pull[i] * p_model.pulls[r_triple.limb_class][i] / 256;
			NumberModel number;
			number.expected = expected + _quotient(motion[i] * along, weight);
			number.level = (common + 64 * _part_bias(p_model, r_triple, i) +
								   p_model.part_speed * _half_log16(motion[i] * motion[i]) + p_model.part * surprise) /
					64;
			number.shares = _context.shares[p_model.shapes[i]];
			number.step = i > 0 ? r_triple.step : 1;
			number.first = i > 0 ? r_triple.numbers[0] & (r_triple.step - 1) : 0;
			if (!_port.number(number, r_triple.numbers[i])) {
				return false;
			}
			const int64_t found = r_triple.numbers[i] * FRACTION;
			r_triple.error[i] = _limited(found - expected, MAX_ERROR);
			along += r_triple.error[i] * motion[i];
			weight += motion[i] * motion[i];
			const int64_t off = _limited(found - number.expected, MAX_ERROR);
			const int now = _half_log16(off * off) - number.level;
			total += now;
			surprise = int(_limited(surprise + now, MAX_SURPRISE));
		}
		r_surprise = int(_limited(total / 3, MAX_SURPRISE));
		_average += (r_surprise - _average) / 4;
		return true;
	}

	// 16 times the logarithm to base 2 of a root, not below that of a unit.
	static int _half_log16(int64_t p_square) { return log16(uint64_t(p_square + SQUARE_FLOOR)) / 2; }
	// Known for the chart that most limbs are in: it has the axes of the limbs.
	static int _part_bias(const MotionModel &p_model, const Triple &p_triple, std::size_t p_part) {
		return p_triple.usual_chart ? p_model.part_biases[p_triple.limb_class][p_part] : 0;
	}
	static int _gain_step(int p_speed) {
		const int step = (p_speed - 64) / 16;
		return step < 0 ? 0 : (step >= GAIN_STEPS ? GAIN_STEPS - 1 : step);
	}

	Port &_port;
	const PersonContext &_context;
	std::array<int, MAX_LIMBS> _surprises{};
	std::array<std::array<int64_t, 3>, MAX_LIMBS> _turns{}; // What hand_on() left.
	int _average = 0;
};

} // namespace wire
