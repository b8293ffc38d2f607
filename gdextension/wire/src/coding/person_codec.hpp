// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_lattice.hpp"
#include "range_coder.hpp"

namespace wire {

/// Codes where a person is, against states that the receiver is known to have. Whole numbers only and
/// nothing that changes: every machine reads the same, and each datagram can be read alone.
///
/// Server and clients need the same skeleton (limbs and parents) and resolution.
class PersonCodec {
public:
	/// Most bytes that a person takes, whatever the states.
	static constexpr int MAX_BYTES = 640;
	/// Ages above this are taken for this.
	static constexpr int MAX_AGE = 255;

	/// p_skeleton has to be sound.
	PersonCodec(const Skeleton &p_skeleton, int p_resolution) :
			_skeleton(p_skeleton), _lattice_resolution(PersonLattice(p_resolution).resolution()) {}

	/// Writes where a person is now. p_base is a state that the receiver has, p_base_age_ticks (60 a
	/// second, 1 or more) older; p_before another one, older still. Both may be null; the receiver
	/// decodes with the same ones.
	void encode(RangeEncoder &p_encoder, const PersonState &p_now, const PersonState *p_base,
			const PersonState *p_before, int p_base_age_ticks, int p_before_age_ticks) const;
	/// Reads it. False for what no encoder writes, as far as that shows; r_now is then of no use. It may not
	/// be one of the others.
	bool decode(RangeDecoder &p_decoder, PersonState &r_now, const PersonState *p_base, const PersonState *p_before,
			int p_base_age_ticks, int p_before_age_ticks) const;

private:
	Skeleton _skeleton;
	int _lattice_resolution;
};

} // namespace wire
