// SPDX-License-Identifier: MIT
#include "private_file.hpp"

#include <algorithm>
#include <vector>

namespace godot {

Error PrivateFile::open(const String &p_path) {
	switch (_file.open(p_path.utf8().get_data())) {
		case host::PrivateFile::Outcome::OPENED:
			return OK;
		case host::PrivateFile::Outcome::BUSY:
			return ERR_BUSY;
		case host::PrivateFile::Outcome::FOREIGN:
			return ERR_FILE_NO_PERMISSION;
		default:
			return ERR_FILE_CANT_OPEN;
	}
}

PackedByteArray PrivateFile::read() const {
	const std::vector<uint8_t> bytes = _file.read();
	PackedByteArray result;
	result.resize(static_cast<int64_t>(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), result.ptrw());
	return result;
}

Error PrivateFile::write(const PackedByteArray &p_bytes) {
	const std::vector<uint8_t> bytes(p_bytes.ptr(), p_bytes.ptr() + p_bytes.size());
	return _file.write(bytes) ? OK : ERR_FILE_CANT_WRITE;
}

Error PrivateFile::remove() {
	return _file.remove() ? OK : ERR_FILE_CANT_WRITE;
}

void PrivateFile::close() {
	_file.close();
}

void PrivateFile::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "path"), &PrivateFile::open);
	ClassDB::bind_method(D_METHOD("read"), &PrivateFile::read);
	ClassDB::bind_method(D_METHOD("write", "bytes"), &PrivateFile::write);
	ClassDB::bind_method(D_METHOD("remove"), &PrivateFile::remove);
	ClassDB::bind_method(D_METHOD("close"), &PrivateFile::close);
}

} // namespace godot
