s/^step = .*/step = "3e-3 s"/
$a [method]\nanti_locking = "B-bar"
