// SPDX-License-Identifier: MIT
#include "motion/pose_stream.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

/// Seconds of turning that lie beyond the newest sample: at first as many as have passed, then fewer,
/// and none when the stream has stalled for long.
double faded(double p_age_s) {
	const double age = std::min(p_age_s, PoseStream::STALL_AFTER);
	const double ahead = PoseStream::RATE_FADE * (1.0 - std::exp(-age / PoseStream::RATE_FADE));
	if (p_age_s <= PoseStream::STALL_AFTER) {
		return ahead;
	}
	const double span = PoseStream::HOLD_AFTER - PoseStream::STALL_AFTER;
	const double left = std::clamp((PoseStream::HOLD_AFTER - p_age_s) / span, 0.0, 1.0);
	return ahead * left * left * (3.0 - 2.0 * left);
}

bool is_rotation(const Quat &p_value) {
	// Written so that NaN fails too.
	const float norm = std::sqrt(p_value.dot(p_value));
	return norm > 0.9f && norm < 1.1f;
}

} // namespace

PoseStream::PoseStream(std::size_t p_limb_count) :
		_limb_count(p_limb_count), _filter(p_limb_count), _turns(p_limb_count, RatePredictor(SMALL_TURN)) {
	for (Sample &sample : _ring) {
		sample.sampled.resize(_limb_count);
		sample.orientations.resize(_limb_count);
		sample.rates.resize(_limb_count);
		sample.turn_changes.resize(_limb_count);
	}
}

void PoseStream::clear() {
	_count = 0;
	_late = 0;
	_teleported = false;
}

bool PoseStream::take_teleport() {
	return std::exchange(_teleported, false);
}

bool PoseStream::push(double p_time_s, const float *p_orientations, const Vec3 &p_root, const float *p_rates) {
	if (!std::isfinite(p_time_s) || !p_root.is_finite()) {
		return false;
	}
	bool is_measured = p_rates != nullptr;
	for (std::size_t i = 0; i < _limb_count; i++) {
		const float *values = p_orientations + 4 * i;
		if (!is_rotation({ values[0], values[1], values[2], values[3] })) {
			return false;
		}
		const Vec3 rate = p_rates ? Vec3{ p_rates[3 * i], p_rates[3 * i + 1], p_rates[3 * i + 2] } : Vec3();
		if (!rate.is_finite()) {
			return false;
		}
		is_measured = is_measured && rate.length() < FASTEST_GYRO;
	}
	if (comes_late(p_time_s)) {
		return false;
	}
	p_rates = is_measured ? p_rates : nullptr;
	const std::size_t next = (_head + 1) % CAPACITY;
	Sample &sample = _ring[next];
	sample.time_s = p_time_s;
	sample.root = p_root;
	for (std::size_t i = 0; i < _limb_count; i++) {
		const float *values = p_orientations + 4 * i;
		sample.sampled[i] = Quat{ values[0], values[1], values[2], values[3] }.normalized();
		sample.orientations[i] = sample.sampled[i];
		sample.rates[i] = p_rates ? Vec3{ p_rates[3 * i], p_rates[3 * i + 1], p_rates[3 * i + 2] } : Vec3();
	}
	sample.root_rate = {};
	if (_count > 0) {
		const float distance = (p_root - at(0).root).length();
		if (distance > TELEPORT_DISTANCE && distance > FASTEST_ROOT * float(p_time_s - newest())) {
			_count = 0;
			_teleported = true;
		} else if (p_time_s - newest() <= MAX_GAP) {
			if (!p_rates) {
				estimate_rates(at(0), sample);
			}
			const double span = p_time_s - newest();
			const float old = _count > 1 ? forgetting(span) : 0.0f;
			sample.root_rate = (p_root - at(0).root) * ((1.0f - old) / float(span)) + at(0).root_rate * old;
		}
	}
	calm(sample, p_rates != nullptr);
	sample.knows_rates = p_rates != nullptr;
	foresee(sample);
	_head = next;
	_count = std::min(_count + 1, CAPACITY);
	return true;
}

bool PoseStream::comes_late(double p_time_s) {
	if (_count == 0 || p_time_s > newest()) {
		_late = 0;
		return false;
	}
	_late = _late > 0 && p_time_s > _latest_late_s ? _late + 1 : 1;
	_latest_late_s = p_time_s;
	if (_late < CLOCK_SET_BACK) {
		return true;
	}
	clear();
	return false;
}

void PoseStream::calm(Sample &r_sample, bool p_knows_rates) {
	const double span = _count > 0 ? r_sample.time_s - newest() : MAX_GAP;
	if (!_calms) {
		_filter.clear();
		return;
	}
	if (span >= MAX_GAP || _filter.is_empty()) {
		_filter.begin(r_sample.sampled);
		return;
	}
	_filter.advance(r_sample.sampled, float(span));
	for (std::size_t i = 0; i < _limb_count && _filter.get_noise() > 0.0f; i++) {
		r_sample.orientations[i] = _filter.get_orientation(i);
		r_sample.rates[i] = p_knows_rates ? r_sample.rates[i] : _filter.get_rate(i).limited(FASTEST_TURN);
	}
}

void PoseStream::foresee(Sample &r_sample) {
	const double span = _count > 0 ? r_sample.time_s - newest() : MAX_GAP;
	const bool follows = span < MAX_GAP;
	const float calmness = 1.0f - _filter.get_unrest(); // A noisy limb would overshoot when its foot lands.
	r_sample.span_s = follows ? span : 0.0;
	for (std::size_t i = 0; i < _limb_count; i++) {
		if (follows) {
			const Vec3 turned = log(at(0).orientations[i].inverse() * r_sample.orientations[i]);
			_turns[i].advance(turned * (1.0f / float(span)), r_sample.rates[i], float(span));
		} else {
			begin(_turns[i], r_sample.rates[i], r_sample.knows_rates);
		}
		r_sample.turn_changes[i] = _turns[i].get_change() * calmness;
	}
	if (follows) {
		_path.advance((r_sample.root - at(0).root) * (1.0f / float(span)), r_sample.root_rate, float(span));
	} else {
		begin(_path, r_sample.root_rate, false);
	}
	r_sample.root_change = _path.get_change();
}

void PoseStream::begin(RatePredictor &r_predictor, const Vec3 &p_rate, bool p_knows_rate) const {
	if (_count == 0) {
		r_predictor.begin();
	} else {
		r_predictor.pause();
	}
	if (p_knows_rate) {
		r_predictor.set_rate(p_rate);
	}
}

float PoseStream::forgetting(double p_span_s) const {
	return float(std::exp(-p_span_s / RATE_MEMORY));
}

void PoseStream::estimate_rates(const Sample &p_before, Sample &r_sample) const {
	const double span = r_sample.time_s - p_before.time_s;
	const float old = _count > 1 ? forgetting(span) : 0.0f;
	const float fresh = (1.0f - old) / float(span);
	for (std::size_t i = 0; i < _limb_count; i++) {
		const Vec3 turned = log(p_before.sampled[i].inverse() * r_sample.sampled[i]);
		r_sample.rates[i] = (turned * fresh + p_before.rates[i] * old).limited(FASTEST_TURN);
	}
}

void PoseStream::predict(double p_time_s, Pose &r_pose) const {
	if (p_time_s >= newest()) {
		r_pose.orientations.resize(_limb_count);
		extrapolate(p_time_s - newest(), r_pose);
		return;
	}
	interpolate(p_time_s, &Sample::orientations, r_pose);
}

void PoseStream::recall(double p_time_s, Pose &r_pose) const {
	interpolate(std::min(p_time_s, newest()), &Sample::sampled, r_pose);
}

std::size_t PoseStream::find_after(double p_time_s) const {
	std::size_t age = 0;
	while (age + 2 < _count && at(age + 1).time_s > p_time_s) {
		age++;
	}
	return age;
}

bool PoseStream::is_stalled(double p_time_s) const {
	if (is_empty() || p_time_s - newest() > STALL_AFTER) {
		return true;
	}
	const std::size_t age = find_after(p_time_s);
	if (age + 1 >= _count) {
		return false;
	}
	const double before = at(age + 1).time_s;
	const double after = at(age).time_s;
	return after - before > MAX_GAP && p_time_s - before > STALL_AFTER && p_time_s < after - SAME_TIME;
}

void PoseStream::interpolate(double p_time_s, std::vector<Quat> Sample::*p_which, Pose &r_pose) const {
	const std::size_t age = find_after(p_time_s);
	const Sample &after = at(age);
	const Sample &before = at(std::min(age + 1, _count - 1));
	const double span = after.time_s - before.time_s;
	if (span <= 0.0 || span > MAX_GAP) {
		const Sample &held = p_time_s < after.time_s - SAME_TIME ? before : after;
		r_pose.orientations = held.*p_which;
		r_pose.root = held.root;
		return;
	}
	const double time = std::max(p_time_s, before.time_s);
	const float fraction = float((time - before.time_s) / span);
	r_pose.orientations.resize(_limb_count);
	for (std::size_t i = 0; i < _limb_count; i++) {
		r_pose.orientations[i] = slerp((before.*p_which)[i], (after.*p_which)[i], fraction);
	}
	r_pose.root = before.root + (after.root - before.root) * fraction;
}

void PoseStream::extrapolate(double p_age_s, Pose &r_pose) const {
	const Sample &newest_sample = at(0);
	const float ahead = float(faded(p_age_s));
	// The change of the mean rate grows with the time ahead. An estimated rate is that of half a span
	// before the sample, a gyroscope's that of the sample. Beyond a span nothing is known of it.
	const float span = float(newest_sample.span_s);
	const float part = span > 0.0f ? std::min(ahead / span, 1.0f) : 0.0f;
	const float begun = newest_sample.knows_rates ? 0.0f : 0.5f;
	const float changed = part * span * (begun + (1.0f - begun) * part);
	for (std::size_t i = 0; i < _limb_count; i++) {
		const Vec3 turn = newest_sample.rates[i] * ahead + newest_sample.turn_changes[i] * changed;
		r_pose.orientations[i] = newest_sample.orientations[i] * exp(turn);
	}
	r_pose.root = newest_sample.root + newest_sample.root_rate * ahead + newest_sample.root_change * changed;
}

void PoseStream::save(ArchiveWriter &p_archive) const {
	p_archive.put(std::uint32_t(_limb_count));
	p_archive.put(std::uint32_t(_count));
	p_archive.put(_teleported);
	p_archive.put(_late);
	p_archive.put(_latest_late_s);
	p_archive.put(_calms);
	_filter.save(p_archive);
	for (std::size_t age = _count; age-- > 0;) {
		const Sample &sample = at(age);
		p_archive.put(sample.time_s);
		p_archive.put(sample.root);
		p_archive.put(sample.root_rate);
		p_archive.put_all(sample.sampled);
		p_archive.put_all(sample.orientations);
		p_archive.put_all(sample.rates);
		p_archive.put_all(sample.turn_changes);
		p_archive.put(sample.root_change);
		p_archive.put(sample.span_s);
		p_archive.put(sample.knows_rates);
	}
	for (const RatePredictor &turns : _turns) {
		turns.save(p_archive);
	}
	_path.save(p_archive);
}

bool PoseStream::restore(ArchiveReader &p_archive) {
	clear();
	std::uint32_t limbs = 0;
	std::uint32_t samples = 0;
	bool jumped = false;
	p_archive.get(limbs);
	p_archive.get(samples);
	p_archive.get(jumped);
	p_archive.get(_late);
	p_archive.get(_latest_late_s);
	p_archive.get(_calms);
	if (!p_archive.is_good() || !_filter.restore(p_archive) || limbs != _limb_count || samples > CAPACITY) {
		return false;
	}
	for (std::uint32_t i = 0; i < samples; i++) {
		_head = (_head + 1) % CAPACITY;
		Sample &sample = _ring[_head];
		p_archive.get(sample.time_s);
		p_archive.get(sample.root);
		p_archive.get(sample.root_rate);
		p_archive.get_all(sample.sampled);
		p_archive.get_all(sample.orientations);
		p_archive.get_all(sample.rates);
		p_archive.get_all(sample.turn_changes);
		p_archive.get(sample.root_change);
		p_archive.get(sample.span_s);
		p_archive.get(sample.knows_rates);
	}
	for (RatePredictor &turns : _turns) {
		turns.restore(p_archive);
	}
	_path.restore(p_archive);
	_count = p_archive.is_good() ? samples : 0;
	_teleported = jumped;
	return p_archive.is_good();
}

} // namespace ragdoll
