// SPDX-License-Identifier: MIT
#include "smoothing/track.hpp"

#include "dead_reckoning.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

namespace {

// A person's motion beyond what people do is a jump, and no base for a prediction.
constexpr float MAX_SPEED = 30.0f; // m/s
constexpr float MAX_SPIN = 40.0f; // rad/s
// A person's speed changes by less than this from one update to the next.
constexpr float MAX_SPEED_CHANGE = 10.0f; // m/s
constexpr float MAX_SPIN_CHANGE = 20.0f; // rad/s
// A jump beyond this is taken over at once: something was put elsewhere.
constexpr float FARTHEST_OFFSET = 3.0f; // m
// At the newest update motion is faster than its mean since the last one by so much of its change.
constexpr float CHANGE = 0.25f;
// How fast the jump of ADAPTIVE_LOW_DELAY decays (critically damped), and that of ERROR_OFFSET.
constexpr double SPRING = 75.0; // 1/s, at up to this time between updates; less where they are rarer.
constexpr double SPRING_GAP = 1.0 / 30.0; // s
// A display of more frames has room for a stiffer spring: the jump is gone sooner, and motion is still smoother.
constexpr double SPRING_FRAME = 1.0 / 60.0; // s: of 60 frames a second it is SPRING.
constexpr double MAX_STIFFENING = 2.4;
constexpr double DECAY = 21.4; // 1/s: to 0.7 within a sixtieth of a second.
// Updates that are further apart are no samples of one motion, s.
constexpr double MAX_GAP = 0.3;
constexpr double MIN_GAP = 1.0 / 240.0;

bool is_jump(const Vec3 &p_displacement) {
	return p_displacement.length() > FARTHEST_OFFSET;
}

// What has just jumped does not go on like that: carried on, it would be shown far beyond where it is.
template <std::size_t N>
void stop_jumps(Delta<N> &r_motion, const Delta<N> &p_change, std::size_t p_count) {
	if (p_change.displacement.length() > CHANGE * MAX_SPEED_CHANGE) {
		r_motion.displacement = Vec3();
	}
	for (std::size_t i = 0; i < p_count; i++) {
		if (p_change.turns[i].length() > CHANGE * MAX_SPIN_CHANGE) {
			r_motion.turns[i] = Vec3();
		}
	}
}

float smooth(double p_part) {
	const double part = std::min(std::max(p_part, 0.0), 1.0);
	return float(part * part * (3.0 - 2.0 * part));
}

} // namespace

template <std::size_t N>
bool Track<N>::push(const Key &p_key) {
	std::size_t index = _size;
	while (index > 0 && _key(index - 1).time > p_key.time) {
		index--;
	}
	const bool is_old = _size == KEPT && index == 0;
	if (is_old || (index > 0 && _key(index - 1).time == p_key.time)) {
		return false;
	}
	uint8_t free = uint8_t(_size);
	if (_size == KEPT) {
		free = _order[0];
		std::copy(_order.begin() + 1, _order.begin() + std::ptrdiff_t(index), _order.begin());
		index--;
	} else {
		std::copy_backward(_order.begin() + std::ptrdiff_t(index), _order.begin() + std::ptrdiff_t(_size),
				_order.begin() + std::ptrdiff_t(_size) + 1);
		_size++;
	}
	_order[index] = free;
	_keys[free] = p_key;
	_has_news = true;
	return true;
}

/// The shortest of the last gaps: how often updates come when none is lost, s.
template <std::size_t N>
double Track<N>::_usual_gap() const {
	double least = MAX_GAP;
	for (std::size_t i = _size - 1; i > 0 && i + 6 > _size; i--) {
		least = std::min(least, _gap(i));
	}
	return std::max(least, MIN_GAP);
}

/// The motion at an update: received, or the mean of the motions before and behind it.
template <std::size_t N>
Delta<N> Track<N>::_motion_of(std::size_t p_index) const {
	if (_has_motion) {
		return _key(p_index).motion;
	}
	const bool has_before = p_index > 0 && _gap(p_index) <= MAX_GAP;
	const bool has_after = p_index + 1 < _size && _gap(p_index + 1) <= MAX_GAP;
	Delta<N> motion;
	if (has_before && has_after) {
		const float before = float(_gap(p_index));
		const float after = float(_gap(p_index + 1));
		const Delta<N> in = between(_key(p_index - 1).frame, _key(p_index).frame, 1.0f / before, _count);
		const Delta<N> out = between(_key(p_index).frame, _key(p_index + 1).frame, 1.0f / after, _count);
		motion = mix(in, after / (before + after), out, before / (before + after), _count);
	} else if (has_before) {
		motion = between(_key(p_index - 1).frame, _key(p_index).frame, float(1.0 / _gap(p_index)), _count);
	} else if (has_after) {
		motion = between(_key(p_index).frame, _key(p_index + 1).frame, float(1.0 / _gap(p_index + 1)), _count);
	}
	limit(motion, MAX_SPEED, MAX_SPIN, _count);
	return motion;
}

/// The motion at the newest update, with what it is about to become.
template <std::size_t N>
Delta<N> Track<N>::_motion_at_end() const {
	Delta<N> motion = _motion_of(_size - 1);
	if (!_has_motion && _size > 2 && _gap(_size - 1) <= MAX_GAP && _gap(_size - 2) <= MAX_GAP) {
		const Delta<N> before =
				between(_key(_size - 3).frame, _key(_size - 2).frame, float(1.0 / _gap(_size - 2)), _count);
		const Delta<N> change = mix(motion, CHANGE, before, -CHANGE, _count);
		motion = mix(motion, 1.0f, change, 1.0f, _count);
		limit(motion, MAX_SPEED, MAX_SPIN, _count);
		stop_jumps(motion, change, _count);
	}
	return motion;
}

/// An update, carried on. Received motion is believed as the server believes that we do; estimated
/// motion runs out.
template <std::size_t N>
Frame<N> Track<N>::_predicted(const Key &p_key, double p_time, const Delta<N> &p_motion, double p_reach) const {
	Frame<N> frame = p_key.frame;
	if (p_key.at_rest) {
		return frame;
	}
	const double ahead = p_time - p_key.time;
	double seconds = 0.0;
	if (_has_motion) {
		seconds = std::min(std::max(ahead, -double(MAX_PREDICTION_S)), double(MAX_PREDICTION_S));
	} else {
		seconds = ahead > 0.0 ? carried_on(ahead, p_reach) : std::max(ahead, -MAX_GAP);
	}
	apply(frame, p_motion, float(seconds), _count);
	return frame;
}

/// The newest update, dead-reckoned.
template <std::size_t N>
Frame<N> Track<N>::_newest_at(double p_time, double p_reach) const {
	return _predicted(_key(_size - 1), p_time, _motion_at_end(), p_reach);
}

/// Between two updates of a body: from where the first predicts it to where the second says that it
/// came from. The prediction holds until shortly before the second: else the server had sent one.
template <std::size_t N>
Frame<N> Track<N>::_blended(std::size_t p_after, double p_time, bool p_eased) const {
	const Key &before = _key(p_after - 1);
	const Key &after = _key(p_after);
	const double window = std::min(_gap(p_after), std::min(_usual_gap(), BUFFER_S));
	const double part = (p_time - (after.time - window)) / window;
	Frame<N> frame = _predicted(before, p_time, before.motion, REACH_S);
	if (part <= 0.0) {
		return frame;
	}
	const Frame<N> back = _predicted(after, p_time, after.motion, REACH_S);
	const float weight = p_eased ? smooth(part) : float(std::min(part, 1.0));
	const Delta<N> whole = between(frame, back, 1.0f, _count);
	apply(frame, whole, is_jump(whole.displacement) ? 0.0f : weight, _count);
	return frame;
}

/// Straight from one update to the next, and no further than the newest.
template <std::size_t N>
Frame<N> Track<N>::_straight(double p_time) const {
	std::size_t after = _size - 1;
	while (after > 0 && _key(after - 1).time >= p_time) {
		after--;
	}
	if (_key(after).time <= p_time) {
		return _has_motion ? _newest_at(p_time, REACH_S) : _key(after).frame;
	}
	if (after == 0) {
		return _key(0).frame;
	}
	if (_has_motion) {
		return _blended(after, p_time, false);
	}
	Frame<N> frame = _key(after - 1).frame;
	const double part = (p_time - _key(after - 1).time) / _gap(after);
	const Delta<N> whole = between(frame, _key(after).frame, 1.0f, _count);
	apply(frame, whole, is_jump(whole.displacement) ? 0.0f : float(part), _count);
	return frame;
}

/// Along a cubic Hermite curve from one update to the next. Beyond the newest it goes on, or not.
template <std::size_t N>
Frame<N> Track<N>::_curved(double p_time, bool p_goes_on) const {
	std::size_t after = _size - 1;
	while (after > 0 && _key(after - 1).time >= p_time) {
		after--;
	}
	if (_key(after).time <= p_time) {
		return p_goes_on || _has_motion ? _newest_at(p_time, REACH_S) : _key(after).frame;
	}
	if (after == 0) {
		return _key(0).frame;
	}
	if (_has_motion) {
		return _blended(after, p_time, true);
	}
	const float span = float(_gap(after));
	const float part = float((p_time - _key(after - 1).time) / _gap(after));
	const float left = 1.0f - part;
	Frame<N> frame = _key(after - 1).frame;
	const Delta<N> whole = between(frame, _key(after).frame, 1.0f, _count);
	if (is_jump(whole.displacement)) {
		return frame;
	}
	Delta<N> displacement = mix(
			_motion_of(after - 1), part * left * left * span, _motion_of(after), -part * part * left * span, _count);
	displacement = mix(displacement, 1.0f, whole, part * part * (3.0f - 2.0f * part), _count);
	apply(frame, displacement, 1.0f, _count);
	return frame;
}

template <std::size_t N>
Frame<N> Track<N>::_wanted(const Moment &p_moment) const {
	switch (p_moment.method) {
		case SmoothingMethod::LINEAR:
			return _straight(p_moment.time);
		case SmoothingMethod::HERMITE:
			return _curved(p_moment.time, false);
		case SmoothingMethod::ADAPTIVE_LOW_DELAY:
			return _curved(p_moment.time, true);
		case SmoothingMethod::ERROR_OFFSET:
			return _newest_at(p_moment.time, FAR_REACH_S);
		default:
			return _key(_size - 1).frame;
	}
}

/// The thesis's method: from what was shown when the update came to where the next one will be.
template <std::size_t N>
void Track<N>::_chase(const Moment &p_moment) {
	if (_has_news) {
		const double due = std::max(_key(_size - 1).arrival + _usual_gap(), p_moment.now);
		_chase_from = is_jump(_shown.position - _key(_size - 1).frame.position) ? _key(_size - 1).frame : _shown;
		_chase_motion = _motion_of(_size - 1);
		_chase_begin = _last.now;
		_chase_span = std::max(due - _last.now, MIN_GAP);
		_chase_to = _key(_size - 1).frame;
		if (!_key(_size - 1).at_rest) {
			apply(_chase_to, _chase_motion, float(_usual_gap()), _count);
		}
	}
	const double part = (p_moment.now - _chase_begin) / _chase_span;
	_shown = _chase_from;
	apply(_shown, between(_chase_from, _chase_to, 1.0f, _count), float(std::min(std::max(part, 0.0), 1.0)), _count);
	if (_has_motion && part > 1.0 && !_key(_size - 1).at_rest) {
		const double beyond = std::min(p_moment.now - _chase_begin - _chase_span, double(MAX_PREDICTION_S));
		apply(_shown, _chase_motion, float(beyond), _count);
	}
}

/// An update has changed what should have been shown last: the difference becomes an offset that goes
/// on as fast as what was shown did.
template <std::size_t N>
void Track<N>::_take_over(const Moment &p_moment) {
	Moment then = _last;
	then.method = p_moment.method;
	const Frame<N> target = _wanted(then);
	_offset = between(target, _shown, 1.0f, _count);
	if (p_moment.method == SmoothingMethod::ADAPTIVE_LOW_DELAY) {
		constexpr double STEP = 1.0 / 240.0;
		then.time -= STEP;
		const Delta<N> target_speed = between(_wanted(then), target, float(1.0 / STEP), _count);
		_offset_speed = mix(_speed, 1.0f, target_speed, -1.0f, _count);
		limit(_offset_speed, MAX_SPEED, MAX_SPIN, _count);
	}
	if (_is_reframed) {
		_offset_speed = Delta<N>();
		_is_reframed = false;
	}
	if (is_jump(_offset.displacement)) {
		_offset = Delta<N>();
		_offset_speed = Delta<N>();
	}
}

template <std::size_t N>
void Track<N>::_decay(const Moment &p_moment, double p_step) {
	if (p_moment.method == SmoothingMethod::ERROR_OFFSET) {
		_offset = mix(_offset, float(std::exp(-DECAY * p_step)), _offset_speed, 0.0f, _count);
		return;
	}
	// A critically damped spring, solved exactly.
	const double stiffening = p_step > 0.0 ? std::min(std::max(SPRING_FRAME / p_step, 1.0), MAX_STIFFENING) : 1.0;
	const double spring = SPRING * stiffening * std::sqrt(std::min(1.0, SPRING_GAP / _usual_gap()));
	const float left = float(std::exp(-spring * p_step));
	const float step = float(p_step);
	const float stiffness = float(spring);
	const Delta<N> pull = mix(_offset_speed, 1.0f, _offset, stiffness, _count);
	_offset = mix(_offset, left, pull, left * step, _count);
	_offset_speed = mix(_offset_speed, left, pull, -left * step * stiffness, _count);
}

template <std::size_t N>
void Track<N>::evaluate(const Moment &p_moment) {
	if (_size == 0) {
		return;
	}
	const bool decays =
			p_moment.method == SmoothingMethod::ERROR_OFFSET || p_moment.method == SmoothingMethod::ADAPTIVE_LOW_DELAY;
	// After a pause there is nothing to go on smoothly from.
	const bool goes_on = _is_shown && p_moment.now - _last.now < MAX_GAP && p_moment.now >= _last.now;
	const double step = goes_on ? p_moment.now - _last.now : 0.0;
	const Frame<N> before = _shown;
	if (!goes_on) {
		_offset = Delta<N>();
		_offset_speed = Delta<N>();
		_shown = _wanted(p_moment);
		_has_news = true;
		_last.now = p_moment.now;
	} else if (decays && (_has_news || p_moment.method != _last.method)) {
		_take_over(p_moment);
	}
	if (p_moment.method == SmoothingMethod::EXTRAPOLATE_LERP) {
		_has_news = _has_news || p_moment.method != _last.method;
		_chase(p_moment);
	} else {
		_shown = _wanted(p_moment);
		if (decays) {
			_decay(p_moment, step);
			apply(_shown, _offset, 1.0f, _count);
		}
	}
	_speed = step > 0.0 ? between(before, _shown, float(1.0 / step), _count) : Delta<N>();
	_has_news = false;
	_is_shown = true;
	_last = p_moment;
}

template class Track<1>;
template class Track<kinematics::MAX_LIMBS>;

} // namespace wire
