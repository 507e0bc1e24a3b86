extern "C" int regions_of_a_tetrahedron();

int main() {
  return regions_of_a_tetrahedron() == 2 ? 0 : 1;
}
