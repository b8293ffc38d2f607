// SPDX-License-Identifier: MIT
#include "saved_ragdoll.hpp"

#include "sealed_state.hpp"

namespace godot {

namespace {

constexpr std::uint32_t STATE_MAGIC = 0x42534D52; // "RMSB"

} // namespace

PackedByteArray save_ragdoll(DrivenRagdoll &r_ragdoll) {
	if (!r_ragdoll.read()) {
		return PackedByteArray();
	}
	const ragdoll::RigState &state = r_ragdoll.get_state();
	ragdoll::ArchiveWriter archive;
	archive.put(STATE_MAGIC);
	r_ragdoll.get_driver().save(archive);
	archive.put_all(state.orientations);
	archive.put_all(state.centres);
	archive.put_all(state.linear);
	archive.put_all(state.angular);
	return seal(archive);
}

bool restore_ragdoll(const PackedByteArray &p_bytes, DrivenRagdoll &r_ragdoll) {
	const String fault = find_seal_fault(p_bytes);
	ERR_FAIL_COND_V_MSG(!fault.is_empty(), false, "RagdollMotor: " + fault + ".");
	ragdoll::ArchiveReader archive = open_sealed(p_bytes);
	ragdoll::RigState &state = r_ragdoll.edit_state();
	std::uint32_t magic = 0;
	const bool fits = archive.get(magic) && magic == STATE_MAGIC && r_ragdoll.get_driver().restore(archive) &&
			archive.get_all(state.orientations) && archive.get_all(state.centres) && archive.get_all(state.linear) &&
			archive.get_all(state.angular) && archive.is_at_end();
	ERR_FAIL_COND_V_MSG(!fits, false, "RagdollMotor: the saved state is of another profile or version.");
	r_ragdoll.put_anew();
	return true;
}

std::uint64_t hash_ragdoll(DrivenRagdoll &r_ragdoll) {
	ragdoll::StateHash hash;
	if (r_ragdoll.read()) {
		const ragdoll::RigState &state = r_ragdoll.get_state();
		for (std::size_t i = 0; i < state.centres.size(); i++) {
			hash.add(state.orientations[i]);
			hash.add(state.centres[i]);
			hash.add(state.linear[i]);
			hash.add(state.angular[i]);
		}
	}
	return hash.get();
}

} // namespace godot
