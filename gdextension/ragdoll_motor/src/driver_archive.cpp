// SPDX-License-Identifier: MIT
// Driver: its state as bytes.
#include "driver.hpp"

namespace ragdoll {

std::uint64_t Driver::fingerprint() const {
	StateHash hash;
	for (std::size_t i = 0; i < _rig.size(); i++) {
		hash.add(_rig[i].parent);
		hash.add(_rig[i].group);
		hash.add(_rig[i].anchor);
		hash.add(_rig[i].centre);
		hash.add(_rig[i].rest);
		hash.add(_rig[i].mass);
	}
	for (const ContactPoint &contact : _contacts) {
		hash.add(contact.limb);
		hash.add(contact.local);
		hash.add(contact.radius);
		hash.add(contact.sole);
	}
	return hash.get();
}

void Driver::save(ArchiveWriter &p_archive) const {
	p_archive.put(fingerprint());
	p_archive.put(root_mode);
	p_archive.put(_alive);
	p_archive.put(_was_limp);
	p_archive.put(_is_getting_up);
	p_archive.put(_upright_s);
	p_archive.put(_gets_up_s);
	p_archive.put(_was_held);
	p_archive.put(_is_fetched);
	p_archive.put(_travelled);
	p_archive.put(_next_root);
	p_archive.put(_arrival_s);
	p_archive.put(_obstructed_s);
	_frame_base.save(p_archive);
	_frame_now.save(p_archive);
	_frame_next.save(p_archive);
	p_archive.put(_is_frame_set);
	_carrier.save(p_archive);
	_tether.save(p_archive);
	for (const std::unique_ptr<Travel> &estimator : _travels) {
		estimator->save(p_archive);
	}
	_foot_lock.save(p_archive);
	_balance.save(p_archive);
	_path.save(p_archive);
	_stream.save(p_archive);
	_table.save(p_archive);
	_controller.save(p_archive);
	_world.save(p_archive);
	_feed_forward.save(p_archive);
}

bool Driver::restore(ArchiveReader &p_archive) {
	ArchiveWriter before;
	save(before);
	if (read(p_archive)) {
		return true;
	}
	ArchiveReader back(before.get_bytes().data(), before.get_bytes().size());
	read(back);
	return false;
}

bool Driver::read(ArchiveReader &p_archive) {
	std::uint64_t whose = 0;
	RootMode mode = RootMode::SOFT;
	// Archives hold indices of tables: those of another body must not come any further.
	if (!p_archive.get(whose) || whose != fingerprint() || !p_archive.get(mode) || int(mode) < 0 ||
			int(mode) >= ROOT_MODE_COUNT || !p_archive.get(_alive) || !p_archive.get(_was_limp) ||
			!p_archive.get(_is_getting_up) || !p_archive.get(_upright_s) || !p_archive.get(_gets_up_s) ||
			!p_archive.get(_was_held) || !p_archive.get(_is_fetched)) {
		return false;
	}
	root_mode = mode;
	_torques.clear();
	p_archive.get(_travelled);
	p_archive.get(_next_root);
	p_archive.get(_arrival_s);
	p_archive.get(_obstructed_s);
	if (!_frame_base.restore(p_archive) || !_frame_now.restore(p_archive) || !_frame_next.restore(p_archive) ||
			!p_archive.get(_is_frame_set) || !_carrier.restore(p_archive) || !_tether.restore(p_archive)) {
		return false;
	}
	for (const std::unique_ptr<Travel> &estimator : _travels) {
		if (!estimator->restore(p_archive)) {
			return false;
		}
	}
	return _foot_lock.restore(p_archive) && _balance.restore(p_archive) && _path.restore(p_archive) &&
			_stream.restore(p_archive) && _table.restore(p_archive) && _controller.restore(p_archive) &&
			_world.restore(p_archive) && _feed_forward.restore(p_archive);
}

} // namespace ragdoll
