// SPDX-License-Identifier: MIT
#include "track.hpp"

#include "../dead_reckoning.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

namespace {

// A person's motion beyond what people do is a jump, and no base for a prediction.
constexpr float FASTEST_WAY = 30.0f; // m/s
constexpr float FASTEST_TURN = 40.0f; // rad/s
// A jump beyond this is taken over at once: something was put elsewhere.
constexpr float FARTHEST_OFFSET = 3.0f; // m
// Beyond the newest update a person goes on ever slower, and no longer than this in sum.
constexpr double REACH_S = 0.06;
// ERROR_OFFSET wants to be where the server is now, and guesses further.
constexpr double FAR_REACH_S = 0.3;
// At the newest update motion is faster than its mean since the last one by so much of its change.
constexpr float CHANGE = 0.25f;
// How fast the jump of ADAPTIVE_LOW_DELAY decays (critically damped), and that of ERROR_OFFSET.
constexpr double SPRING = 75.0; // 1/s, at up to this time between updates; less where they are rarer.
constexpr double SPRING_GAP = 1.0 / 30.0; // s
constexpr double DECAY = 21.4; // 1/s: to 0.7 within a sixtieth of a second.
// Updates that are further apart are no samples of one motion, s.
constexpr double LONGEST_GAP = 0.3;
constexpr double SHORTEST_GAP = 1.0 / 240.0;

bool is_jump(const Vec3 &p_way) {
	return p_way.length() > FARTHEST_OFFSET;
}

float smooth(double p_part) {
	const double part = std::min(std::max(p_part, 0.0), 1.0);
	return float(part * part * (3.0 - 2.0 * part));
}

} // namespace

template <std::size_t N>
bool Track<N>::push(const Key &p_key) {
	std::size_t place = size;
	while (place > 0 && key(place - 1).time > p_key.time) {
		place--;
	}
	const bool is_old = size == KEPT && place == 0;
	if (is_old || (place > 0 && key(place - 1).time == p_key.time)) {
		return false;
	}
	uint8_t free = uint8_t(size);
	if (size == KEPT) {
		free = order[0];
		std::copy(order.begin() + 1, order.begin() + std::ptrdiff_t(place), order.begin());
		place--;
	} else {
		std::copy_backward(order.begin() + std::ptrdiff_t(place), order.begin() + std::ptrdiff_t(size),
				order.begin() + std::ptrdiff_t(size) + 1);
		size++;
	}
	order[place] = free;
	keys[free] = p_key;
	has_news = true;
	return true;
}

/// The shortest of the last gaps: how often updates come when none is lost, s.
template <std::size_t N>
double Track<N>::usual_gap() const {
	double least = LONGEST_GAP;
	for (std::size_t i = size - 1; i > 0 && i + 6 > size; i--) {
		least = std::min(least, gap(i));
	}
	return std::max(least, SHORTEST_GAP);
}

/// The motion at an update: received, or the mean of the ways before and behind it.
template <std::size_t N>
Shift<N> Track<N>::motion_of(std::size_t p_place) const {
	if (has_motion) {
		return key(p_place).motion;
	}
	const bool has_before = p_place > 0 && gap(p_place) <= LONGEST_GAP;
	const bool has_after = p_place + 1 < size && gap(p_place + 1) <= LONGEST_GAP;
	Shift<N> motion;
	if (has_before && has_after) {
		const float before = float(gap(p_place));
		const float after = float(gap(p_place + 1));
		const Shift<N> in = between(key(p_place - 1).frame, key(p_place).frame, 1.0f / before, count);
		const Shift<N> out = between(key(p_place).frame, key(p_place + 1).frame, 1.0f / after, count);
		motion = mix(in, after / (before + after), out, before / (before + after), count);
	} else if (has_before) {
		motion = between(key(p_place - 1).frame, key(p_place).frame, float(1.0 / gap(p_place)), count);
	} else if (has_after) {
		motion = between(key(p_place).frame, key(p_place + 1).frame, float(1.0 / gap(p_place + 1)), count);
	}
	limit(motion, FASTEST_WAY, FASTEST_TURN, count);
	return motion;
}

/// The motion at the newest update, with what it is about to become.
template <std::size_t N>
Shift<N> Track<N>::motion_at_end() const {
	Shift<N> motion = motion_of(size - 1);
	if (!has_motion && size > 2 && gap(size - 1) <= LONGEST_GAP && gap(size - 2) <= LONGEST_GAP) {
		const Shift<N> before = between(key(size - 3).frame, key(size - 2).frame, float(1.0 / gap(size - 2)), count);
		motion = mix(motion, 1.0f + CHANGE, before, -CHANGE, count);
		limit(motion, FASTEST_WAY, FASTEST_TURN, count);
	}
	return motion;
}

/// An update, carried on. Received motion is believed as the server believes that we do; estimated
/// motion runs out.
template <std::size_t N>
Frame<N> Track<N>::predicted(const Key &p_key, double p_time, const Shift<N> &p_motion, double p_reach) const {
	Frame<N> frame = p_key.frame;
	if (p_key.at_rest) {
		return frame;
	}
	const double ahead = p_time - p_key.time;
	double seconds = 0.0;
	if (has_motion) {
		seconds = std::min(std::max(ahead, -double(LONGEST_PREDICTION_S)), double(LONGEST_PREDICTION_S));
	} else if (ahead > 0.0) {
		seconds = p_reach * (1.0 - std::exp(-ahead / p_reach));
	}
	apply(frame, p_motion, float(seconds), count);
	return frame;
}

/// The newest update, dead-reckoned.
template <std::size_t N>
Frame<N> Track<N>::newest_at(double p_time, double p_reach) const {
	return predicted(key(size - 1), p_time, motion_at_end(), p_reach);
}

/// Between two updates of a body: from where the first predicts it to where the second says that it
/// came from. The prediction holds until shortly before the second: else the server had sent one.
template <std::size_t N>
Frame<N> Track<N>::blended(std::size_t p_after, double p_time, bool p_eased) const {
	const Key &before = key(p_after - 1);
	const Key &after = key(p_after);
	const double window = std::min(gap(p_after), std::min(usual_gap(), BUFFER_S));
	const double part = (p_time - (after.time - window)) / window;
	Frame<N> frame = predicted(before, p_time, before.motion, REACH_S);
	if (part <= 0.0) {
		return frame;
	}
	const Frame<N> back = predicted(after, p_time, after.motion, REACH_S);
	const float weight = p_eased ? smooth(part) : float(std::min(part, 1.0));
	const Shift<N> whole = between(frame, back, 1.0f, count);
	apply(frame, whole, is_jump(whole.way) ? 0.0f : weight, count);
	return frame;
}

/// Straight from one update to the next, and no further than the newest.
template <std::size_t N>
Frame<N> Track<N>::straight(double p_time) const {
	std::size_t after = size - 1;
	while (after > 0 && key(after - 1).time >= p_time) {
		after--;
	}
	if (key(after).time <= p_time) {
		return has_motion ? newest_at(p_time, REACH_S) : key(after).frame;
	}
	if (after == 0) {
		return key(0).frame;
	}
	if (has_motion) {
		return blended(after, p_time, false);
	}
	Frame<N> frame = key(after - 1).frame;
	const double part = (p_time - key(after - 1).time) / gap(after);
	const Shift<N> whole = between(frame, key(after).frame, 1.0f, count);
	apply(frame, whole, is_jump(whole.way) ? 0.0f : float(part), count);
	return frame;
}

/// Along a cubic Hermite curve from one update to the next. Beyond the newest it goes on, or not.
template <std::size_t N>
Frame<N> Track<N>::curved(double p_time, bool p_goes_on) const {
	std::size_t after = size - 1;
	while (after > 0 && key(after - 1).time >= p_time) {
		after--;
	}
	if (key(after).time <= p_time) {
		return p_goes_on || has_motion ? newest_at(p_time, REACH_S) : key(after).frame;
	}
	if (after == 0) {
		return key(0).frame;
	}
	if (has_motion) {
		return blended(after, p_time, true);
	}
	const float span = float(gap(after));
	const float part = float((p_time - key(after - 1).time) / gap(after));
	const float left = 1.0f - part;
	Frame<N> frame = key(after - 1).frame;
	const Shift<N> whole = between(frame, key(after).frame, 1.0f, count);
	if (is_jump(whole.way)) {
		return frame;
	}
	Shift<N> way =
			mix(motion_of(after - 1), part * left * left * span, motion_of(after), -part * part * left * span, count);
	way = mix(way, 1.0f, whole, part * part * (3.0f - 2.0f * part), count);
	apply(frame, way, 1.0f, count);
	return frame;
}

template <std::size_t N>
Frame<N> Track<N>::wanted(const Moment &p_moment) const {
	switch (p_moment.method) {
		case SmoothingMethod::LINEAR:
			return straight(p_moment.time);
		case SmoothingMethod::HERMITE:
			return curved(p_moment.time, false);
		case SmoothingMethod::ADAPTIVE_LOW_DELAY:
			return curved(p_moment.time, true);
		case SmoothingMethod::ERROR_OFFSET:
			return newest_at(p_moment.time, FAR_REACH_S);
		default:
			return key(size - 1).frame;
	}
}

/// The thesis's way: from what was shown when the update came to where the next one will be.
template <std::size_t N>
void Track<N>::chase(const Moment &p_moment) {
	if (has_news) {
		const double due = std::max(key(size - 1).arrival + usual_gap(), p_moment.now);
		chase_from = is_jump(shown.position - key(size - 1).frame.position) ? key(size - 1).frame : shown;
		chase_motion = motion_of(size - 1);
		chase_begin = last.now;
		chase_span = std::max(due - last.now, SHORTEST_GAP);
		chase_to = key(size - 1).frame;
		if (!key(size - 1).at_rest) {
			apply(chase_to, chase_motion, float(usual_gap()), count);
		}
	}
	const double part = (p_moment.now - chase_begin) / chase_span;
	shown = chase_from;
	apply(shown, between(chase_from, chase_to, 1.0f, count), float(std::min(std::max(part, 0.0), 1.0)), count);
	if (has_motion && part > 1.0 && !key(size - 1).at_rest) {
		const double beyond = std::min(p_moment.now - chase_begin - chase_span, double(LONGEST_PREDICTION_S));
		apply(shown, chase_motion, float(beyond), count);
	}
}

/// An update has changed what should have been shown last: the difference becomes an offset that goes
/// on as fast as what was shown did.
template <std::size_t N>
void Track<N>::take_over(const Moment &p_moment) {
	Moment then = last;
	then.method = p_moment.method;
	const Frame<N> target = wanted(then);
	offset = between(target, shown, 1.0f, count);
	if (p_moment.method == SmoothingMethod::ADAPTIVE_LOW_DELAY) {
		constexpr double STEP = 1.0 / 240.0;
		then.time -= STEP;
		const Shift<N> target_speed = between(wanted(then), target, float(1.0 / STEP), count);
		offset_speed = mix(speed, 1.0f, target_speed, -1.0f, count);
		limit(offset_speed, FASTEST_WAY, FASTEST_TURN, count);
	}
	if (is_jump(offset.way)) {
		offset = Shift<N>();
		offset_speed = Shift<N>();
	}
}

template <std::size_t N>
void Track<N>::decay(const Moment &p_moment, double p_step) {
	if (p_moment.method == SmoothingMethod::ERROR_OFFSET) {
		offset = mix(offset, float(std::exp(-DECAY * p_step)), offset_speed, 0.0f, count);
		return;
	}
	// A critically damped spring, solved exactly.
	const double spring = SPRING * std::sqrt(std::min(1.0, SPRING_GAP / usual_gap()));
	const float left = float(std::exp(-spring * p_step));
	const float step = float(p_step);
	const float stiffness = float(spring);
	const Shift<N> pull = mix(offset_speed, 1.0f, offset, stiffness, count);
	offset = mix(offset, left, pull, left * step, count);
	offset_speed = mix(offset_speed, left, pull, -left * step * stiffness, count);
}

template <std::size_t N>
void Track<N>::show(const Moment &p_moment) {
	if (size == 0) {
		return;
	}
	const bool decays =
			p_moment.method == SmoothingMethod::ERROR_OFFSET || p_moment.method == SmoothingMethod::ADAPTIVE_LOW_DELAY;
	// After a pause there is nothing to go on smoothly from.
	const bool goes_on = is_shown && p_moment.now - last.now < LONGEST_GAP && p_moment.now >= last.now;
	const double step = goes_on ? p_moment.now - last.now : 0.0;
	const Frame<N> before = shown;
	if (!goes_on) {
		offset = Shift<N>();
		offset_speed = Shift<N>();
		shown = wanted(p_moment);
		has_news = true;
		last.now = p_moment.now;
	} else if (decays && (has_news || p_moment.method != last.method)) {
		take_over(p_moment);
	}
	if (p_moment.method == SmoothingMethod::EXTRAPOLATE_LERP) {
		has_news = has_news || p_moment.method != last.method;
		chase(p_moment);
	} else {
		shown = wanted(p_moment);
		if (decays) {
			decay(p_moment, step);
			apply(shown, offset, 1.0f, count);
		}
	}
	speed = step > 0.0 ? between(before, shown, float(1.0 / step), count) : Shift<N>();
	has_news = false;
	is_shown = true;
	last = p_moment;
}

template class Track<1>;
template class Track<kinematics::MAX_LIMBS>;

} // namespace wire
