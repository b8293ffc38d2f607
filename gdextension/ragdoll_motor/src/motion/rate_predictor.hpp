// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/calm.hpp"
#include "base/vectors.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

/// Predicts by how much a rate will have changed when the next sample comes.
///
/// A rate that a sample brings is that of the past. A limb that goes on with it lags where it speeds up, and
/// overshoots where it brakes. How much of the last change of the rate comes again is learnt from the
/// motion itself, as the one coefficient of a linear predictor by least squares with exponential
/// forgetting (Haykin, Adaptive Filter Theory, recursive least squares): nearly all of it in a smooth
/// dance, none of it in a recording of 30 frames a second, and less than none where white noise makes
/// every change go back. A change that is much larger than those before is a blow or a glitch, and says
/// little about what follows: only the usual size of it counts.
class RatePredictor {
public:
	/// The past is forgotten over this time, s.
	static constexpr float MEMORY_S = 0.5f;
	/// A change counts whole up to this many times the root mean square of the changes before it.
	static constexpr float USUAL = 3.0f;
	/// The least and the most of a change that comes again. White noise on positions gives -2/3, an
	/// even acceleration 1.
	static constexpr float LEAST = -0.6f;
	static constexpr float MOST = 1.0f;
	/// What is believed of the first change, until the next ones tell.
	static constexpr float FIRST = 0.25f;

	/// @param p_smallest changes below this say nothing, in the rate's unit
	explicit RatePredictor(float p_smallest) : _smallest(p_smallest) {}

	/// Begins anew. What has been learnt is forgotten, but after a pause.
	void begin() {
		pause();
		_product = _square = _size = _weight = 0.0f;
	}
	/// The next sample tells no change: nothing is known of the rate before.
	void pause() {
		_knows_rate = false;
		_change = {};
	}
	/// The rate itself is known, from a gyroscope.
	void set_rate(const Vec3 &p_rate) {
		_rate = p_rate;
		_knows_rate = true;
	}
	/// Takes what the new sample tells.
	/// @param p_moved the mean rate since the sample before
	/// @param p_rate the rate that is gone on with from now
	/// @param p_span_s time since the sample before, s
	void advance(const Vec3 &p_moved, const Vec3 &p_rate, float p_span_s) {
		if (!_knows_rate) {
			set_rate(p_rate);
			return;
		}
		const float fresh = share(p_span_s, MEMORY_S);
		const Vec3 change = p_rate - _rate;
		// The first changes are all that is known of what is usual.
		const float usual = _weight > 0.0f ? USUAL * std::sqrt(_size / _weight) + _smallest : change.length();
		const Vec3 surprise = (p_moved - _rate).limited(usual);
		if (_weight > 0.0f) {
			_product += fresh * (surprise.dot(_change) - _product);
			_square += fresh * (_change.dot(_change) - _square);
		} else {
			_square = fresh * change.dot(change);
			_product = FIRST * _square;
		}
		_change = change.limited(usual);
		_size += fresh * (_change.dot(_change) - _size);
		_weight += fresh * (1.0f - _weight);
		_rate = p_rate;
	}
	/// The change of the mean rate until the next sample, if that comes after as long a time.
	Vec3 get_change() const { return _change * std::clamp(_product / (_square + _smallest * _smallest), LEAST, MOST); }

	void save(ArchiveWriter &p_archive) const {
		p_archive.put(_rate);
		p_archive.put(_change);
		p_archive.put(_product);
		p_archive.put(_square);
		p_archive.put(_size);
		p_archive.put(_weight);
		p_archive.put(_knows_rate);
	}
	void restore(ArchiveReader &p_archive) {
		p_archive.get(_rate);
		p_archive.get(_change);
		p_archive.get(_product);
		p_archive.get(_square);
		p_archive.get(_size);
		p_archive.get(_weight);
		p_archive.get(_knows_rate);
	}

private:
	float _smallest;
	Vec3 _rate;
	Vec3 _change; // The last one, limited.
	float _product = 0.0f; // Of surprises and the changes before them, mean.
	float _square = 0.0f; // Of the changes, mean.
	float _size = 0.0f; // The same up to the last change: what is usual, once it is divided by
	float _weight = 0.0f; // how much has been seen of it: 0 nothing, 1 enough.
	bool _knows_rate = false;
};

} // namespace ragdoll
