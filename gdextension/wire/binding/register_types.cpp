// SPDX-License-Identifier: MIT
#include "local_feedback.hpp"
#include "motion_decoder.hpp"
#include "motion_encoder.hpp"
#include "person_stream.hpp"
#include "quickest_arrivals.hpp"
#include "skeleton_poser.hpp"
#include "snapshot_decoder.hpp"
#include "snapshot_encoder.hpp"
#include "snapshot_smoother.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(LocalFeedback);
		GDREGISTER_CLASS(MotionDecoder);
		GDREGISTER_CLASS(MotionEncoder);
		GDREGISTER_CLASS(PersonStream);
		GDREGISTER_CLASS(QuickestArrivals);
		GDREGISTER_CLASS(SkeletonPoser);
		GDREGISTER_CLASS(SnapshotDecoder);
		GDREGISTER_CLASS(SnapshotEncoder);
		GDREGISTER_CLASS(SnapshotSmoother);
	}
}

void terminate(ModuleInitializationLevel) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT wire_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
