// SPDX-License-Identifier: MIT
#include "coding/person_codec.hpp"

#include "coding/person_coder.hpp"
#include "coding/person_contexts.hpp"

namespace wire {

void PersonCodec::encode(RangeEncoder &p_encoder, const PersonState &p_now, const PersonState *p_base,
		const PersonState *p_before, int p_base_age_ticks, int p_before_age_ticks) const {
	const PersonContext context =
			make_context(_skeleton, _lattice_resolution, p_base, p_before, p_base_age_ticks, p_before_age_ticks);
	NumberWriter writer(p_encoder);
	PersonState state = p_now;
	PersonCoder<NumberWriter>(writer, context).code(state);
}

bool PersonCodec::decode(RangeDecoder &p_decoder, PersonState &r_now, const PersonState *p_base,
		const PersonState *p_before, int p_base_age_ticks, int p_before_age_ticks) const {
	const PersonContext context =
			make_context(_skeleton, _lattice_resolution, p_base, p_before, p_base_age_ticks, p_before_age_ticks);
	NumberReader reader(p_decoder);
	return PersonCoder<NumberReader>(reader, context).code(r_now);
}

} // namespace wire
