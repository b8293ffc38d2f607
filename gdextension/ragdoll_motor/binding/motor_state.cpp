// SPDX-License-Identifier: MIT
// RagdollMotor: its state as bytes, and as a fingerprint.
#include "ragdoll_motor.hpp"
#include "sealed_state.hpp"

namespace godot {

namespace {

constexpr std::uint32_t STATE_MAGIC = 0x37534D52; // "RMS7"

} // namespace

PackedByteArray RagdollMotor::save_state() {
	if (!_driver || !_bodies->read(_state)) {
		return PackedByteArray();
	}
	ragdoll::ArchiveWriter archive;
	archive.put(STATE_MAGIC);
	_driver->save(archive);
	archive.put_all(_state.orientations);
	archive.put_all(_state.centres);
	archive.put_all(_state.linear);
	archive.put_all(_state.angular);
	return seal(archive);
}

bool RagdollMotor::restore_state(const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_V_MSG(!_driver, false, "RagdollMotor: restore_state() comes after setup().");
	const String fault = find_seal_fault(p_bytes);
	ERR_FAIL_COND_V_MSG(!fault.is_empty(), false, "RagdollMotor: " + fault + ".");
	ragdoll::ArchiveReader archive = open_sealed(p_bytes);
	std::uint32_t magic = 0;
	const bool fits = archive.get(magic) && magic == STATE_MAGIC && _driver->restore(archive) &&
			archive.get_all(_state.orientations) && archive.get_all(_state.centres) && archive.get_all(_state.linear) &&
			archive.get_all(_state.angular) && archive.is_at_end();
	ERR_FAIL_COND_V_MSG(!fits, false, "RagdollMotor: the saved state is of another profile or version.");
	_root_mode = RootMode(_driver->root_mode);
	look_at_ground();
	// New joints know nothing of the impulses of the time before: every replay begins the same.
	_is_state_read = false;
	_bodies->remake();
	_bodies->put(_state);
	return true;
}

int64_t RagdollMotor::get_state_hash() {
	ragdoll::StateHash hash;
	if (_driver && _bodies->read(_state)) {
		for (std::size_t i = 0; i < _state.centres.size(); i++) {
			hash.add(_state.orientations[i]);
			hash.add(_state.centres[i]);
			hash.add(_state.linear[i]);
			hash.add(_state.angular[i]);
		}
	}
	return int64_t(hash.get());
}

} // namespace godot
