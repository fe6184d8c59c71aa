# SPDX-License-Identifier: MIT

# For all of it: linked as one program, which makes it smaller; a small sort instead of libc++'s; and instructions that
# every engine with SIMD has.
target_compile_options(firma PUBLIC $<BUILD_INTERFACE:-flto;-mbulk-memory;-mnontrapping-fptoint;-msign-ext>
                                    "$<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${PROJECT_SOURCE_DIR}/bindings/wasm/small_sort.h>>")
target_link_options(firma PUBLIC $<BUILD_INTERFACE:-flto>)
