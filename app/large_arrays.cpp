#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

// A step walks through some thirty arrays of up to millions of numbers. On pages of 4 KiB the processor spends a tenth
// of it, or more, on finding them: large arrays ask the system for large pages, which gives them where it has them.
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20U;

void* allocate(std::size_t size) {
  // What is left over at the end gets one of its own if it nearly fills it.
  const std::size_t n_large = (size + large_page / 4) / large_page;
  if (n_large == 0) return std::malloc(size > 0 ? size : 1);
  void* memory = std::aligned_alloc(large_page, (size + large_page - 1) / large_page * large_page);
  // A refusal changes nothing.
  if (memory != nullptr) static_cast<void>(madvise(memory, n_large * large_page, MADV_HUGEPAGE));
  return memory;
}

}  // namespace

// NOLINTBEGIN(misc-new-delete-overloads): the other forms of the library call these.
void* operator new(std::size_t size) {
  void* memory = allocate(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
// NOLINTEND(misc-new-delete-overloads)
