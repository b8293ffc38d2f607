extends TestCase
## Which renderer draws does not depend on what drivers a machine happens to have.


func test_a_processor_draws_by_opengl() -> void:
	equal(RendererChoice.choose("auto", "", "forward_plus", true), "gl_compatibility")
	equal(RendererChoice.choose("auto", "", "mobile", true), "gl_compatibility")
	equal(RendererChoice.choose("auto", "", "gl_compatibility", true), "gl_compatibility")


func test_a_graphics_card_draws_by_what_the_engine_has_chosen() -> void:
	equal(RendererChoice.choose("auto", "", "forward_plus", false), "forward_plus")
	equal(RendererChoice.choose("auto", "", "gl_compatibility", false), "gl_compatibility")


func test_the_user_has_the_last_word() -> void:
	equal(RendererChoice.choose("auto", "forward_plus", "forward_plus", true), "forward_plus")
	equal(RendererChoice.choose("mobile", "", "forward_plus", true), "mobile")
	equal(RendererChoice.choose("forward_plus", "", "gl_compatibility", true), "forward_plus")
