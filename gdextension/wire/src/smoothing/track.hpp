// SPDX-License-Identifier: MIT
#pragma once

#include "smoothing/frame.hpp"
#include "smoothing/smoothing_method.hpp"

namespace wire {

/// What is known of one person or body, and what is shown of it.
///
/// Times are the server's, s. Nothing here allocates.
template <std::size_t N>
class Track {
public:
	/// One update.
	struct Key {
		double time = 0.0;
		double arrival = 0.0; ///< In the client's clock.
		Frame<N> frame;
		Delta<N> motion; ///< Per second; only where it is received.
		bool at_rest = false;
	};

	/// What a frame of the display is made for.
	struct Moment {
		double time = 0.0; ///< What is to be shown, in the server's time.
		double now = 0.0; ///< The client's clock.
		SmoothingMethod method = SmoothingMethod::ADAPTIVE_LOW_DELAY;
	};

	/// Updates that are kept.
	static constexpr std::size_t KEPT = N == 1 ? 16 : 32;

	/// p_count of N orientations are in use. Where motion is received it is believed (dead reckoning);
	/// elsewhere it is estimated from successive updates.
	explicit Track(std::size_t p_count, bool p_has_motion) : _count(p_count), _has_motion(p_has_motion) {}

	/// Takes an update; whether it says anything new.
	bool push(const Key &p_key);
	/// Works out what is shown at a moment.
	void evaluate(const Moment &p_moment);
	/// Where it is at a time (s), as far as that is known; there has to be an update.
	Frame<N> at(double p_time) const { return _curved(p_time, true); }
	/// Gives all in another carrier's frame: updates by p_convert(frame, time), and what is shown by
	/// p_convert_shown(frame). What is shown then goes on from there, at the speed of the updates.
	template <typename Convert, typename ConvertShown>
	void reframe(Convert p_convert, ConvertShown p_convert_shown) {
		for (std::size_t i = 0; i < _size; i++) {
			Key &key = _keys[_order[i]];
			key.frame = p_convert(key.frame, key.time);
		}
		_shown = p_convert_shown(_shown);
		_chase_from = p_convert_shown(_chase_from);
		_chase_to = p_convert_shown(_chase_to);
		_is_reframed = true;
		_has_news = true;
	}
	/// Forgets all but what is shown now.
	void clear() { _size = 0; }

	bool is_empty() const { return _size == 0; }
	const Frame<N> &get_shown() const { return _shown; }
	const Key &get_newest() const { return _key(_size - 1); }

private:
	const Key &_key(std::size_t p_index) const { return _keys[_order[p_index]]; }
	double _gap(std::size_t p_index) const { return _key(p_index).time - _key(p_index - 1).time; }
	double _usual_gap() const;
	Delta<N> _motion_of(std::size_t p_index) const;
	Delta<N> _motion_at_end() const;
	Frame<N> _predicted(const Key &p_key, double p_time, const Delta<N> &p_motion, double p_reach) const;
	Frame<N> _straight(double p_time) const;
	Frame<N> _curved(double p_time, bool p_goes_on) const;
	Frame<N> _blended(std::size_t p_after, double p_time, bool p_eased) const;
	Frame<N> _newest_at(double p_time, double p_reach) const;
	Frame<N> _wanted(const Moment &p_moment) const;
	void _chase(const Moment &p_moment);
	void _decay(const Moment &p_moment, double p_step);
	void _take_over(const Moment &p_moment);

	std::size_t _count;
	bool _has_motion;
	std::array<Key, KEPT> _keys{};
	std::array<uint8_t, KEPT> _order{};
	std::size_t _size = 0;

	bool _is_shown = false;
	bool _has_news = false;
	bool _is_reframed = false; // The speed of what is shown is in another frame.
	Moment _last;
	Frame<N> _shown;
	Delta<N> _speed; // Of what is shown, per second.
	Delta<N> _offset; // From what is wanted to what is shown: a jump that decays.
	Delta<N> _offset_speed;
	// EXTRAPOLATE_LERP: from where, to where, when.
	Frame<N> _chase_from;
	Frame<N> _chase_to;
	Delta<N> _chase_motion;
	double _chase_begin = 0.0;
	double _chase_span = 0.0;
};

extern template class Track<1>;
extern template class Track<kinematics::MAX_LIMBS>;

} // namespace wire
