// SPDX-License-Identifier: MIT
#pragma once

#include "frame.hpp"
#include "smoothing_method.hpp"

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
		Shift<N> motion; ///< Per second; only where it is received.
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
	explicit Track(std::size_t p_count, bool p_has_motion) : count(p_count), has_motion(p_has_motion) {}

	/// Takes an update; whether it says anything new.
	bool push(const Key &p_key);
	/// Works out what is shown at a moment.
	void show(const Moment &p_moment);
	/// Forgets all but what is shown now.
	void clear() { size = 0; }

	bool is_empty() const { return size == 0; }
	const Frame<N> &get_shown() const { return shown; }
	const Key &get_newest() const { return key(size - 1); }

private:
	const Key &key(std::size_t p_place) const { return keys[order[p_place]]; }
	double gap(std::size_t p_place) const { return key(p_place).time - key(p_place - 1).time; }
	double usual_gap() const;
	Shift<N> motion_of(std::size_t p_place) const;
	Shift<N> motion_at_end() const;
	Frame<N> predicted(const Key &p_key, double p_time, const Shift<N> &p_motion, double p_reach) const;
	Frame<N> straight(double p_time) const;
	Frame<N> curved(double p_time, bool p_goes_on) const;
	Frame<N> blended(std::size_t p_after, double p_time, bool p_eased) const;
	Frame<N> newest_at(double p_time, double p_reach) const;
	Frame<N> wanted(const Moment &p_moment) const;
	void chase(const Moment &p_moment);
	void decay(const Moment &p_moment, double p_step);
	void take_over(const Moment &p_moment);

	std::size_t count;
	bool has_motion;
	std::array<Key, KEPT> keys{};
	std::array<uint8_t, KEPT> order{};
	std::size_t size = 0;

	bool is_shown = false;
	bool has_news = false;
	Moment last;
	Frame<N> shown;
	Shift<N> speed; // Of what is shown, per second.
	Shift<N> offset; // From what is wanted to what is shown: a jump that decays.
	Shift<N> offset_speed;
	// EXTRAPOLATE_LERP: from where, to where, when.
	Frame<N> chase_from;
	Frame<N> chase_to;
	Shift<N> chase_motion;
	double chase_begin = 0.0;
	double chase_span = 0.0;
};

extern template class Track<1>;
extern template class Track<kinematics::MAX_LIMBS>;

} // namespace wire
